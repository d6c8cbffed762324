// What a person does with a setting's widget: drag, type, restore, and what the scene becomes.
#include <doctest/doctest.h>

#include "app/panels/docks.hpp"
#include "app/panels/memory.hpp"
#include "app/panels/panels.hpp"
#include "app/widgets/setting_help.hpp"
#include "app/widgets/setting_widget.hpp"
#include "app/widgets/slider.hpp"
#include "tests/panels/harness.hpp"

using namespace pf;
using namespace pf::app;

namespace {

constexpr float width = 270, height = 400;

/// One widget in a window, and a hand.
struct Hand {
  explicit Hand(std::string which, const Scene& scene = rich_scene()) : h(scene), pointer(std::move(which)) {
    ImGuiIO& io = ImGui::GetIO();
    for (const int key : {ImGuiKey_Enter, ImGuiKey_Escape, ImGuiKey_A, ImGuiKey_Delete}) io.KeyMap[key] = 300 + key;
    io.MousePos = ImVec2(-100, -100);
    show(3);
  }
  std::string show(int frames = 1) {
    std::vector<Letter> found;
    for (int i = 0; i < frames; ++i)
      found = h.frame(ImVec2(width, height), [&](AppContext& c) { setting_widget(c, pointer); });
    return reading(found);
  }
  void press(ImVec2 at, int button = 0) {
    ImGui::GetIO().MousePos = at;
    show(2);
    ImGui::GetIO().MouseDown[button] = true;
    show();
  }
  void click(ImVec2 at, int button = 0) {
    press(at, button);
    ImGui::GetIO().MouseDown[button] = false;
    show(2);
  }
  void type(const char* text) {
    show(2);
    ImGui::GetIO().AddInputCharactersUTF8(text);
    show();
    key(ImGuiKey_Enter);
  }
  void key(int k) {
    ImGui::GetIO().KeysDown[300 + k] = true;
    show();
    ImGui::GetIO().KeysDown[300 + k] = false;
    show(2);
  }
  /// In the slider's track, `share` of the way.
  ImVec2 on_track(float share) const {
    const ImVec2 pad = ImGui::GetStyle().WindowPadding;
    return {pad.x + share * (width - 2 * pad.x), pad.y + ImGui::GetFrameHeight() + 0.5F * ImGui::GetFontSize()};
  }
  ImVec2 on_value() const {
    const ImVec2 pad = ImGui::GetStyle().WindowPadding;
    return {width - pad.x - 0.7F * ImGui::GetFontSize(), pad.y + 0.5F * ImGui::GetFrameHeight()};
  }

  Harness h;
  std::string pointer;
};

bool says(const std::string& text, const std::string& what) {
  return text.find(what) != std::string::npos;
}

}  // namespace

TEST_CASE("dragging a slider edits the scene, within the slider's range") {
  Hand hand("/transfer/flip_ratio");
  hand.press(hand.on_track(0.5F));
  CHECK(hand.h.context.scene.transfer.flip_ratio == doctest::Approx(0.5).epsilon(0.02));
  ImGui::GetIO().MousePos = ImVec2(5000, hand.on_track(0).y);
  hand.show(2);
  CHECK(hand.h.context.scene.transfer.flip_ratio == 1);
  ImGui::GetIO().MouseDown[0] = false;
  hand.show();
  CHECK(hand.h.context.unsaved);
}

TEST_CASE("a click on the value or Ctrl+click on the slider types it, with units") {
  Hand hand("/time/step");
  hand.click(hand.on_value());
  hand.type("5 ms");
  CHECK(hand.h.context.scene.time.step == doctest::Approx(0.005));
  ImGui::GetIO().KeyCtrl = true;
  hand.click(hand.on_track(0.9F));
  ImGui::GetIO().KeyCtrl = false;
  CHECK(hand.h.context.scene.time.step == doctest::Approx(0.005));  // not dragged there
  hand.type("1/60");
  CHECK(hand.h.context.scene.time.step == doctest::Approx(1.0 / 60));
}

TEST_CASE("a typed value out of range is refused with the range, and the scene keeps its own") {
  Hand hand("/transfer/flip_ratio");
  hand.click(hand.on_value());
  hand.type("1.5");
  CHECK(hand.h.context.scene.transfer.flip_ratio == 0.95);
  const std::string text = hand.show(2);
  CHECK(says(text, "1.5isnotallowed"));
  CHECK(says(text, "0to1"));
  // The next good value takes the message away.
  hand.click(hand.on_value());
  hand.type("0.5");
  CHECK(hand.h.context.scene.transfer.flip_ratio == 0.5);
  CHECK_FALSE(says(hand.show(2), "notallowed"));
}

TEST_CASE("Esc leaves a half-typed value as it was") {
  Hand hand("/transfer/flip_ratio");
  hand.click(hand.on_value());
  hand.show(2);
  ImGui::GetIO().AddInputCharactersUTF8("0.1");
  hand.show();
  hand.key(ImGuiKey_Escape);
  CHECK(hand.h.context.scene.transfer.flip_ratio == 0.95);
}

TEST_CASE("a middle click brings back the value as it was opened") {
  Hand hand("/transfer/flip_ratio");
  hand.press(hand.on_track(0.25F));
  ImGui::GetIO().MouseDown[0] = false;
  hand.show(2);
  REQUIRE(hand.h.context.scene.transfer.flip_ratio < 0.5);
  hand.click(hand.on_track(0.6F), 2);
  CHECK(hand.h.context.scene.transfer.flip_ratio == 0.95);
}

TEST_CASE("a setting that a reset applies says so once it differs from the run") {
  Hand hand("/materials/soft/density");
  CHECK_FALSE(says(hand.show(), "Resettoapply"));
  hand.click(hand.on_value());
  hand.type("1200");
  CHECK(hand.h.context.scene.materials[0].density == 1200);
  CHECK(says(hand.show(2), "Resettoapply"));
  ++hand.h.context.status.run;  // the run was built again
  CHECK_FALSE(says(hand.show(2), "Resettoapply"));
}

TEST_CASE("settings without effect are not drawn") {
  CHECK(says(Hand("/transfer/flip_ratio").show(), "FLIP"));
  CHECK(Hand("/transfer/flip_ratio", plain_scene()).show().empty());  // APIC
  CHECK(Hand("/bodies/0/seed").show().empty());                       // a lattice
  CHECK(Hand("/no/such/setting").show().empty());
}

TEST_CASE("slider positions and values invert one another") {
  for (const SliderRange& r : {SliderRange{0, 1, false, false}, SliderRange{1e3, 1e9, true, false},
                               SliderRange{-20, 20, false, false}, SliderRange{1, 6, false, true}}) {
    CHECK(slider_value(0, r) == r.min);
    CHECK(slider_value(1, r) == r.max);
    for (double p = 0; p <= 1; p += 0.05) {
      const double v = slider_value(p, r);
      CHECK(v >= r.min);
      CHECK(v <= r.max);
      CHECK(slider_position(v, r) == doctest::Approx(p).epsilon(r.integer ? 0.11 : 0.006));
      if (r.integer) CHECK(v == std::round(v));
    }
  }
}

TEST_CASE("every setting explains itself") {
  for (const Setting& s : settings()) {
    CAPTURE(s.pointer);
    CHECK_FALSE(s.label.empty());
    CHECK_FALSE(help_text(s, false).empty());
  }
}
