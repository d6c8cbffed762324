// The overlay, painted by a painter that only notes where things go.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "render/overlay.hpp"

using namespace pf;

namespace {

struct Box {
  float left, top, right, bottom;
  std::string text;
};

class NotingPainter : public Painter {
 public:
  std::vector<Box> texts;

  void polyline(std::span<const Point2>, Color, float, float) override {}
  void polygon(std::span<const Point2>, Color) override {}
  void rectangle(Point2, Point2, Color, float) override {}
  void circle(Point2, float, Color) override {}
  void ring(Point2, float, Color, float) override {}
  void text(Point2 at, std::string_view text, float size, Color color, TextAlign align, FontWeight weight,
            int quarter_turns) override {
    if (color.a < 0.9f) return;  // the rim of a text
    const float w = text_width(text, size, weight);
    const float x = align == TextAlign::left ? at.x : align == TextAlign::centre ? at.x - 0.5f * w : at.x - w;
    if (quarter_turns == 1) {  // upwards, always centred here
      texts.push_back({at.x - 0.75f * size, at.y - 0.5f * w, at.x + 0.2f * size, at.y + 0.5f * w, std::string(text)});
      return;
    }
    texts.push_back({x, at.y - 0.75f * size, x + w, at.y + 0.2f * size, std::string(text)});
  }
  float text_width(std::string_view text, float size, FontWeight) const override {
    return 0.58f * size * static_cast<float>(text.size());
  }
  void push_clip(Point2, Point2) override {}
  void pop_clip() override {}
};

OverlayInfo example(bool flat) {
  OverlayInfo info;
  info.title = "Welcome";
  info.time = 1.25;
  info.dt = 1.0 / 60;
  info.step = 75;
  info.range = {0, 3.2};
  if (flat)
    info.camera = Camera2D{{0, 0}, 420};
  else
    info.camera = OrbitCamera{};
  info.arrow_pixels_per_speed = 12;
  return info;
}

}  // namespace

TEST_CASE("texts of the overlay neither overlap nor leave the view") {
  for (const bool flat : {true, false}) {
    for (const Field field : {Field::speed, Field::J, Field::pressure, Field::material}) {
      for (const ViewSize view : {ViewSize{320, 240}, {800, 600}, {1280, 720}, {3840, 2160}}) {
        const auto w = static_cast<float>(view.width), h = static_cast<float>(view.height);
        OverlayInfo info = example(flat);
        info.size = view;
        info.field = field;
        if (field == Field::pressure) info.range = {-2.5e6, 2.5e6};
        info.material_names = {"rubber", "gel", "a material with a long name"};
        NotingPainter painter;
        draw_overlay(info, RenderTheme::dark(), painter, {0, 0}, {w, h});
        CHECK(painter.texts.size() > 5);
        for (std::size_t a = 0; a < painter.texts.size(); ++a) {
          const Box& A = painter.texts[a];
          INFO(A.text);
          CHECK((A.left >= 0 && A.top >= 0 && A.right <= w && A.bottom <= h));
          for (std::size_t b = 0; b < a; ++b) {
            const Box& B = painter.texts[b];
            INFO(B.text);
            CHECK((A.right <= B.left || B.right <= A.left || A.bottom <= B.top || B.bottom <= A.top));
          }
        }
      }
    }
  }
}

TEST_CASE("scale bars have round lengths in a fitting unit") {
  CHECK(round_length(0.07).text == "5 cm");
  CHECK(round_length(1.4).text == "1 m");
  CHECK(round_length(260).text == "200 m");
  CHECK(round_length(7300).text == "5 km");
  CHECK(round_length(0.0024).text == "2 mm");
  CHECK(round_length(6e-6).text == "5 \u00b5m");
  CHECK(round_length(1).metres == 1);
}
