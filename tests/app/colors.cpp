// The colour bar under the mouse, the menus of fields, crosses.
#include <chrono>
#include <cmath>
#include <fstream>
#include <thread>

#include "tests/app/find_text.hpp"

using namespace pf;
using namespace pf::app;
using namespace pf::app::staged;

namespace {

bool stage_shows(Stage& stage, Field field) {
  return stage.until([&] {
    const auto& s = stage.context().snapshot;
    return !s->field[static_cast<std::size_t>(field)].empty();
  });
}

/// A place on the bar, 0 below to 1 above.
Point2 on_bar(Stage& stage, float position) {
  const auto ends = stage->view().color_bar().ends();
  REQUIRE(ends);
  const auto [top, bottom] = *ends;
  return {top.x, bottom.y + position * (top.y - bottom.y)};
}

}  // namespace

TEST_CASE("dragging keeps the value under the mouse, on every kind of scale") {
  const ValueRange plain = dragged({0, 10}, 0.9, 0.45, ColorScale::from_zero, 0);
  CHECK(plain.min == 0);
  CHECK(plain.max == doctest::Approx(20));  // 9 is now at 0.45
  const ValueRange low = dragged({2, 10}, 0.25, 0.5, ColorScale::spread, 0);
  CHECK(low.max == 10);
  CHECK(low.min == doctest::Approx(-2));  // 4 is now half way
  const ValueRange about = dragged({-10, 10}, 1, 0.75, ColorScale::symmetric, 0);
  CHECK(about.max == doctest::Approx(20));
  CHECK(about.min == doctest::Approx(-20));
  const ValueRange J = dragged({0.9, 1.1}, 0, 0.25, ColorScale::symmetric, 1);
  CHECK(J.min == doctest::Approx(0.8));
  CHECK(J.max == doctest::Approx(1.2));
  const ValueRange log = dragged({1, 1e4}, 0.75, 0.6, ColorScale::logarithmic, 0);
  CHECK(log.min == doctest::Approx(1));
  CHECK(std::log10(log.max) == doctest::Approx(5));
  CHECK(dragged({0, 1}, 1, -3, ColorScale::from_zero, 0).max < 100);  // never endless
}

TEST_CASE("the colour bar: drag its scale, double click for the automatic range, right click for a logarithm") {
  NEEDS_DISPLAY();
  Stage stage(shipped("drooping-cantilever"));
  REQUIRE(stage.ready());
  REQUIRE(stage.steps(6));
  stage.frames(4);
  AppContext& context = stage.context();
  ViewState& view = context.view;
  REQUIRE_FALSE(view.lock_range);
  Hand hand(stage);
  hand.drag(on_bar(stage, 0.9F), on_bar(stage, 0.45F));
  CHECK(view.lock_range);
  const double twice = view.range_max;
  CHECK(view.range_min == 0);
  // A second press there within a third of a second would be a double click.
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  stage.frames(2);
  hand.drag(on_bar(stage, 0.9F), on_bar(stage, 0.45F));
  CHECK(view.range_max == doctest::Approx(2 * twice).epsilon(0.05));
  hand.click(on_bar(stage, 0.5F));
  CHECK(view.lock_range);
  hand.click(on_bar(stage, 0.5F));  // soon after: a double click
  CHECK_FALSE(view.lock_range);
  stage.frames(30);
  hand.click(on_bar(stage, 0.5F), 1);
  stage.frames(3);
  click_text(stage, "Logarithmic");
  CHECK(view.log_colors);
  const Image logarithmic = stage->screenshot();
  view.color_by(view.field);
  CHECK_FALSE(view.log_colors);
  CHECK(stage->screenshot().pixels != logarithmic.pixels);
}

TEST_CASE("every field of the menu is shown, and only that one is worked out") {
  NEEDS_DISPLAY();
  for (const char* name : {"drooping-cantilever", "twisted-bar"}) {
    CAPTURE(name);
    Stage stage(shipped(name));
    REQUIRE(stage.ready());
    AppContext& context = stage.context();
    context.session.set_rate(0);
    REQUIRE(stage.steps(2));
    for (std::size_t k = 0; k < fields().size(); ++k) {
      const FieldInfo& info = fields()[k];
      CAPTURE(info.key);
      const bool offered = stage->offers_field(static_cast<int>(k));
      CHECK(offered == (info.field != Field::error && info.field != Field::material &&
                        (context.scene.dimension == 3 || !info.only_in_3d)));
      if (!offered) continue;
      stage->act(Action::field, static_cast<int>(k));
      REQUIRE(stage_shows(stage, info.field));
      const Snapshot& s = *context.snapshot;
      CHECK(s.field[k].size() == (info.on_nodes ? s.nodes : s.particles));
      for (std::size_t other = 0; other < fields().size(); ++other)
        if (other != k) CHECK(s.field[other].empty());
      stage.frames(2);
    }
    CHECK(context.problems.empty());
  }
}

TEST_CASE("a field is chosen in the menu of its group; crosses come and go with a key") {
  NEEDS_DISPLAY();
  Stage stage(shipped("drooping-cantilever"));
  REQUIRE(stage.ready());
  REQUIRE(stage.steps(3));
  AppContext& context = stage.context();
  click_menu(stage, "View");
  click_when_shown(stage, "Colour by");
  click_when_shown(stage, "Stress");
  click_when_shown(stage, "Stress xx");
  CHECK(context.view.field == Field::stress_xx);
  REQUIRE(stage_shows(stage, Field::stress_xx));
  CHECK(context.snapshot->stress.empty());
  const Image without = stage->screenshot();
  stage->act(Action::crosses);
  REQUIRE(stage.until([&] { return !context.snapshot->stress.empty(); }));
  CHECK(stage.until([] { return find_text("tension").has_value(); }));
  CHECK(stage->screenshot().pixels != without.pixels);
  stage->act(Action::crosses);
  REQUIRE(stage.until([&] { return context.snapshot->stress.empty(); }));
}

TEST_CASE("the energy's account is saved from its panel, as it stands") {
  NEEDS_DISPLAY();
  Stage stage(small(), false, 1, true);
  REQUIRE(stage.ready());
  stage.context().show_plot("Energy balance");
  stage.frames(6);
  REQUIRE(stage.steps(8));
  stage.frames(4);
  click_text(stage, "Save as CSV");
  click_text(stage, "JSON");
  std::size_t rows = 0;
  std::ifstream in(stage.folder / "pictures" / "small-ball-energy.csv");
  for (std::string line; std::getline(in, line);) ++rows;
  CHECK(rows == 10);  // a header, the state before, eight steps
  CHECK(fs::exists(stage.folder / "pictures" / "small-ball-energy.json"));
}
