#include <doctest/doctest.h>
#include <imgui.h>

#include <array>
#include <cmath>
#include <limits>

#include "app/imgui_painter.hpp"
#include "app/theme.hpp"

using namespace pf;
using namespace pf::app;

namespace {

/// ImGui without a window: fonts, a frame, a list to draw on.
struct Sheet {
  Sheet() {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().DisplaySize = {400, 300};
    build_fonts(1);
    ImGui::GetIO().Fonts->SetTexID(reinterpret_cast<ImTextureID>(1));
    ImGui::NewFrame();
  }
  ~Sheet() {
    ImGui::EndFrame();
    ImGui::DestroyContext();
  }
  ImDrawList& list() { return *ImGui::GetBackgroundDrawList(); }
  /// Bounds of what `paint` adds.
  std::array<float, 4> bounds(auto paint) {
    const int first = list().VtxBuffer.Size;
    paint();
    std::array<float, 4> box{1e9f, 1e9f, -1e9f, -1e9f};
    for (int i = first; i < list().VtxBuffer.Size; ++i) {
      const ImVec2 p = list().VtxBuffer[i].pos;
      box = {std::min(box[0], p.x), std::min(box[1], p.y), std::max(box[2], p.x), std::max(box[3], p.y)};
    }
    return box;
  }
};

}  // namespace

TEST_CASE("turned text is whole beside the window's edge, and runs upwards") {
  Sheet sheet;
  ImGuiPainter painter(sheet.list());
  const std::string words = "von Mises stress [Pa]";
  const int before = sheet.list().VtxBuffer.Size;
  painter.text({100, 100}, words, 13, {1, 1, 1, 1});
  const int flat = sheet.list().VtxBuffer.Size - before;
  CHECK(flat == 4 * 18);  // a rectangle a letter; none for the three spaces
  const float width = painter.text_width(words, 13);
  const auto box = sheet.bounds([&] {
    painter.text({390, 150}, words, 13, {1, 1, 1, 1}, TextAlign::centre, FontWeight::regular, 1);
  });
  CHECK(sheet.list().VtxBuffer.Size - before == 2 * flat);
  CHECK(box[3] - box[1] == doctest::Approx(width).epsilon(0.05));
  CHECK((box[1] + box[3]) / 2 == doctest::Approx(150).epsilon(0.02));
  CHECK(box[2] <= 394);  // descenders to the right of the baseline
  CHECK(box[0] >= 375);
}

TEST_CASE("a painter's unit is `scale` pixels") {
  Sheet sheet;
  ImGuiPainter twice(sheet.list(), 2);
  const auto box = sheet.bounds([&] { twice.rectangle({10, 20}, {30, 40}, {1, 1, 1, 1}); });
  CHECK(box == std::array<float, 4>{20, 40, 60, 80});
  const ImGuiPainter once(sheet.list());
  CHECK(twice.text_width("1.25", 15) == doctest::Approx(0.5 * static_cast<double>(once.text_width("1.25", 30))));
}

TEST_CASE("a polygon that is not convex is filled inside only") {
  Sheet sheet;
  ImGuiPainter painter(sheet.list());
  // An L of area 3 in units of 100 x 100 pixels, either way around.
  std::vector<Point2> corner{{0, 0}, {200, 0}, {200, 100}, {100, 100}, {100, 200}, {0, 200}};
  for (int way = 0; way < 2; ++way) {
    const ImDrawList& list = sheet.list();
    const int first = list.IdxBuffer.Size;
    painter.polygon(corner, {1, 1, 1, 1});
    double area = 0;
    for (int i = first; i + 2 < list.IdxBuffer.Size; i += 3) {
      const ImVec2 a = list.VtxBuffer[list.IdxBuffer[i]].pos, b = list.VtxBuffer[list.IdxBuffer[i + 1]].pos,
                   c = list.VtxBuffer[list.IdxBuffer[i + 2]].pos;
      area += std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    }
    CHECK(area == doctest::Approx(3e4).epsilon(0.01));
    std::reverse(corner.begin(), corner.end());
  }
}

TEST_CASE("the font has Greek, operators, sub- and superscripts, arrows") {
  Sheet sheet;
  for (const int symbol :
       {0x03BB, 0x03BC, 0x03C8, 0x2207, 0x2211, 0x2202, 0x2264, 0x00B2, 0x2080, 0x2192, 0x2013, 0x00D7})
    for (const ImFont* font : ImGui::GetIO().Fonts->Fonts) {
      CAPTURE(symbol);
      CHECK(font->FindGlyphNoFallback(static_cast<ImWchar>(symbol)) != nullptr);
    }
}
