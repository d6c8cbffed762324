// A window made for its picture, and the sizes and themes in which each view of it is looked at.
#pragma once

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "app/compare/desk.hpp"
#include "app/inside/step_player.hpp"
#include "app/lessons/desk.hpp"
#include "app/panels/memory.hpp"
#include "tests/app/find_text.hpp"
#include "tests/app/hand.hpp"

namespace pf::app::staged {

/// A window of a given size.
struct Sized {
  int width = 1280, height = 800;
  float scale = 1;
  Theme theme = Theme::dark;
};

struct Shot : Stage {
  Hand hand{*this};

  Point2 pixel(const Vec3& where) { return at(*this, where); }
  Vec3 middle() {
    const Snapshot& s = *context().snapshot;
    const auto d = static_cast<std::size_t>(s.dimension);
    Vec3 sum = Vec3::Zero();
    for (std::size_t p = 0; p < s.particles; ++p)
      for (std::size_t a = 0; a < d; ++a) sum[static_cast<int>(a)] += s.x[d * p + a];
    return sum / static_cast<double>(s.particles);
  }
  explicit Shot(const Sized& size) : Stage(small()) {
    bench.reset();
    Preferences p;
    p.window_width = size.width;
    p.window_height = size.height;
    p.ui_scale = size.scale;
    p.theme = size.theme;
    Workbench::Setup setup;
    setup.visible = false;
    setup.run = false;
    setup.folders = {folder / "config", folder / "state"};
    setup.pictures = folder / "pictures";
    setup.studies = folder / "studies";
    save_preferences(p, setup.folders);
    bench = std::make_unique<Workbench>(small(), fs::path(), setup);
    context().session.set_rate(0);
  }
  void show(const std::string& scene, long count) {
    const std::uint64_t before = context().status.run;
    bench->open_scene(shipped(scene), {}, false);
    until([&] { return context().status.run != before && context().status.state == RunState::paused; });
    ready();
    bench->act(Action::fit);
    steps(count);
  }
  void slow_at(PhaseKind kind, double f) {
    bench->act(Action::slow_step);
    until([&] { return context().slow != nullptr; });
    StepPlayer& player = *context().slow;
    player.playing = false;
    for (std::size_t k = player.phases().size(); k-- > 0;)
      if (player.phases()[k].kind == kind) player.seek(static_cast<double>(k) + f);
  }
  void lesson_at(std::size_t lesson, std::size_t page, bool work) {
    open_lesson(context(), shipped_lessons().at(lesson));
    ready();
    for (std::size_t k = 0; k <= page; ++k) {
      if (k > 0) context().lesson->turn_to(context(), k);
      frames(3);
      ready();
      if (k == page && !work) break;
      context().lesson->help(context());
      const LessonPage& p = context().lesson->page();
      until([&] { return context().lesson->seen() && context().lesson->task_done(context()); });
      if (p.question) context().lesson->answer_ = p.question->answer;
    }
  }
  /// Lanes to a time of theirs.
  void act_until(double time) {
    context().compare->comparison.set_rate(0);
    until([&] {
      frames(1);
      return context().compare->status.time >= time || !context().compare->active();
    });
    context().compare->comparison.pause();
    until([&] { return context().compare->status.state != CompareState::running; });
  }
  /// Clicks the words once a part of the window that can be seen says so; turns the wheel over `scrolled` until then.
  void tap(const std::string& words, Rect scrolled = {}, int button = 0) {
    INFO(words);
    std::optional<Point2> where;
    for (int turn = 0; turn < 60; ++turn) {
      frames(2);
      if ((where = find_whole_text(words)) || scrolled.empty()) break;
      hand.move({scrolled.x + 0.5F * scrolled.width, scrolled.y + 0.5F * scrolled.height});
      hand.wheel(-1);
    }
    REQUIRE(where);
    hand.click(*where, button);
    frames(3);
  }
  /// Puts the mouse where it covers nothing.
  void rest() {
    const Rect& view = bench->layout().view;
    hand.move({view.x + 2, view.bottom() - 2});
  }
  Image take(bool fit = true) {
    frames(12);
    until([&] { return !context().status.step_in_flight; });
    if (fit) bench->act(Action::fit);
    frames(4);
    return bench->screenshot();
  }
};

/// What the window is made to show.
struct WindowView {
  const char* name;
  void (*prepare)(Shot&);
  bool fit = true;       ///< the camera last
  bool trouble = false;  ///< problems are what it shows
};

/// As it is looked at: both themes, three sizes.
inline std::vector<std::pair<std::string, Sized>> all_sizes() {
  return {{"-dark", {}},
          {"-light", {1280, 800, 1, Theme::light}},
          {"-hd-dark", {1920, 1080, 1, Theme::dark}},
          {"-hd-light", {1920, 1080, 1, Theme::light}},
          {"-200-dark", {1920, 1080, 2, Theme::dark}},
          {"-200-light", {1280, 800, 2, Theme::light}}};
}

/// Makes those of `views` that are wished for (PUSHFORWARD_SCREENS, PUSHFORWARD_SCREEN), else the one of that name;
/// with `keep` all of them, as they are kept there, in the usual size.
inline void take_pictures(const std::vector<WindowView>& views, const std::string& usual,
                          const std::function<fs::path(const std::string&)>& keep = {}) {
  const char* screens = std::getenv("PUSHFORWARD_SCREENS");
  const char* only = std::getenv("PUSHFORWARD_SCREEN");
  const auto sizes = screens != nullptr ? all_sizes() : std::vector<std::pair<std::string, Sized>>{{"", {}}};
  for (const WindowView& view : views) {
    const std::string name = view.name;
    if (only != nullptr ? name != only : screens == nullptr && !keep && name != usual) continue;
    for (const auto& [suffix, size] : sizes) {
      CAPTURE(name + suffix);
      Shot shot(size);
      REQUIRE(shot.ready());
      view.prepare(shot);
      const Image image = shot.take(view.fit);
      CHECK(image.width == size.width);
      CHECK(shot.context().problems.empty() != view.trouble);
      CHECK(shot.context().snapshot->particles > 100);
      if (screens != nullptr) write_png(image, fs::path(screens) / (name + suffix + ".png"));
      if (keep) write_png(image, keep(name));
    }
  }
}

}  // namespace pf::app::staged
