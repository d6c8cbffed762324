// What is written over the view stays clear of what is shown in it, at every size of window and text.
#include "tests/app/shot.hpp"

using namespace pf;
using namespace pf::app;
using namespace pf::app::staged;

namespace {

/// Where the colour bar itself is, with its numbers.
Rect bar_of(Shot& s) {
  const auto ends = s.bench->view().color_bar().ends();
  REQUIRE(ends);
  const float em = ImGui::GetFontSize();
  const Point2 low{std::min(ends->first.x, ends->second.x), std::min(ends->first.y, ends->second.y)};
  const Point2 high{std::max(ends->first.x, ends->second.x), std::max(ends->first.y, ends->second.y)};
  return {low.x - em, low.y - em, high.x - low.x + 2 * em, high.y - low.y + 2 * em};
}

/// How many particles are drawn under `place`.
int under(Shot& s, const Rect& place) {
  const Snapshot& snapshot = *s.context().snapshot;
  const auto d = static_cast<std::size_t>(snapshot.dimension);
  int count = 0;
  for (std::size_t p = 0; p < snapshot.particles; ++p) {
    const Point2 at = s.pixel({snapshot.x[d * p], snapshot.x[d * p + 1], d == 3 ? snapshot.x[d * p + 2] : 0});
    count += place.contains(at.x, at.y) ? 1 : 0;
  }
  return count;
}

/// The tools, in a column or as the one in hand.
Rect tools_of(Shot& s) {
  const float em = ImGui::GetFontSize();
  const Rect& v = s.bench->layout().view;
  const auto last = find_whole_text("Ball"), first = find_whole_text("Grab");
  REQUIRE(first);
  return {v.x, v.y, first->x + 2.3F * em - v.x, (last ? last->y : first->y) + 0.8F * em - v.y};
}

}  // namespace

TEST_CASE("neither tools nor colours stand before the fitted material, whatever the window and the text") {
  NEEDS_DISPLAY();
  for (const auto& [suffix, size] : all_sizes()) {
    if (size.theme == Theme::light && size.scale == 1) continue;
    for (const char* scene : {"drooping-cantilever", "twisted-bar"})
      for (const bool drawer : {false, true}) {
        CAPTURE(suffix + " " + scene + (drawer ? " with a plot" : ""));
        Shot shot(size);
        REQUIRE(shot.ready());
        shot.show(scene, 0);
        if (drawer) shot.context().show_plot("Energy");
        shot.frames(6);
        shot.bench->act(Action::fit);
        shot.frames(4);
        CHECK(under(shot, bar_of(shot)) == 0);
        CHECK(under(shot, tools_of(shot)) == 0);
      }
  }
}

TEST_CASE("beside what is read about a particle the view keeps a width that can be worked in") {
  NEEDS_DISPLAY();
  for (const auto& [suffix, size] : all_sizes()) {
    if (size.theme == Theme::light && size.scale == 1) continue;
    CAPTURE(suffix);
    Shot shot(size);
    REQUIRE(shot.ready());
    shot.show("drooping-cantilever", 1);
    shot.context().selected_particle = shot.context().snapshot->id[300];
    shot.until([&] { return shot.context().looked.has_value(); });
    shot.frames(6);
    CHECK(shot.bench->layout().view.width >= 18 * ImGui::GetFontSize());
    // How fast it runs can be read, and that the text goes on below can be seen: there is a bar to scroll by.
    CHECK((find_whole_text("Real time") || find_whole_text("real time")));
  }
}
