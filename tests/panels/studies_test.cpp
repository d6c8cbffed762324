// The Studies drawer in a person's hands: set up, started, read, clicked.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <thread>

#include "app/panels/memory.hpp"
#include "app/panels/panels.hpp"
#include "app/studies/desk.hpp"
#include "core/scene/scene_io.hpp"
#include "core/studies/study.hpp"
#include "tests/panels/harness.hpp"
#include "tests/studies/small_study.hpp"
#include "tests/temporary_folder.hpp"

using namespace pf;
using namespace pf::app;

namespace {

/// The panel in a window of the drawer's usual size, and a hand.
struct Drawer {
  test::TemporaryFolder results;
  Harness h;
  ImVec2 size;

  explicit Drawer(const Scene& scene, float scale = 1, ImVec2 of_window = ImVec2(1000, 300))
      : h(scene, scale > 1 ? Theme::light : Theme::dark, scale), size(of_window) {
    ImGui::GetIO().MousePos = ImVec2(-100, -100);
    h.context.study_folder = results.path();
    h.context.adopt = [this](const Scene& next, bool, const std::string&) { h.context.scene = next; };
    show(3);
  }
  ~Drawer() { h.context.studies.reset(); }
  StudyDesk& desk() { return studies_of(h.context); }
  std::vector<Letter> show(int frames = 1) {
    std::vector<Letter> found;
    for (int i = 0; i < frames; ++i) found = h.frame(size, draw_studies_panel);
    return found;
  }
  void point(ImVec2 at) {
    ImGui::GetIO().MousePos = at;
    show(2);
  }
  void click(ImVec2 at) {
    point(at);
    ImGui::GetIO().MouseDown[0] = true;
    show();
    ImGui::GetIO().MouseDown[0] = false;
    show(3);
  }
  /// The middle of a word as it is drawn; NaN where it is not.
  ImVec2 find(const std::string& word) {
    const std::vector<Letter> found = show(2);
    for (std::size_t k = 0; k + word.size() <= found.size(); ++k) {
      bool same = true;
      for (std::size_t i = 0; i < word.size(); ++i) same = same && found[k + i].code == static_cast<unsigned>(word[i]);
      if (same)
        return {0.5F * (found[k].min.x + found[k + word.size() - 1].max.x), 0.5F * (found[k].min.y + found[k].max.y)};
    }
    return {NAN, NAN};
  }
  bool says(const std::string& word) { return find(word).x > 0; }
  bool until(const std::function<bool()>& done) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    while (!done()) {
      if (std::chrono::steady_clock::now() > deadline) return false;
      show();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
  }
  /// Counted work, short runs: a study that takes a moment.
  void make_quick() {
    desk().draft.cost = "work";
    desk().draft.end = 0.04;
  }
};

Scene bar() {
  return parse_scene(test::bar_scene, "bar");
}

/// With the mouse away: a tooltip may lie over what it is about.
void check(Drawer& d) {
  d.point(ImVec2(-100, -100));
  const std::vector<Letter> found = d.show(2);
  CHECK(found.size() > 10);
  CHECK(overlaps(found) == "");
}

}  // namespace

TEST_CASE("a proposed study is started with one click; a click on a dot opens its setting") {
  Drawer d(bar());
  d.make_quick();
  check(d);
  CHECK(d.says("Vary"));
  CHECK(d.says("Timestep"));
  d.click(d.find("Start"));
  REQUIRE(d.until([&] { return d.desk().status.stage == StudyStage::finished; }));
  const std::size_t runs = d.desk().results->rows.size();
  CHECK(runs == size_of(d.desk().draft, bar()).runs);
  check(d);
  CHECK(d.says("runsdone"));
  CHECK(d.says("youarehere"));
  // Look for the dots with the mouse, then click on one that is another setting.
  ImVec2 dot(NAN, NAN);
  for (float x = 320; x < d.size.x && !(dot.x > 0); x += 9)
    for (float y = 20; y < d.size.y - 40 && !(dot.x > 0); y += 9) {
      d.point({x, y});
      if (d.says("Clicktousethesesettings") && d.says("SymplecticEuler(explicit),time")) dot = {x, y};
    }
  REQUIRE(dot.x > 0);
  d.click(dot);
  CHECK(d.h.context.scene.integrator.type == "symplectic_euler");
  REQUIRE(d.desk().place);
  CHECK(d.desk().place->setting(*d.desk().results->study).has_value());
}

TEST_CASE("dots come one by one, a cancelled study keeps its own and goes on") {
  Drawer d(bar());
  d.make_quick();
  d.desk().draft.axes = {{"/time/step", {0.004, 0.002, 0.001, 0.0005, 0.0002, 0.0001, 0.00005}}};
  d.click(d.find("Start"));
  std::vector<std::size_t> seen;
  REQUIRE(d.until([&] {
    if (d.desk().results) seen.push_back(d.desk().results->rows.size());
    return !seen.empty() && seen.back() >= 2;
  }));
  d.desk().runner.cancel();
  REQUIRE(d.until([&] { return d.desk().status.stage == StudyStage::ready; }));
  const std::size_t kept = d.desk().results->rows.size();
  CHECK(kept >= 2);
  CHECK(kept < 7);
  CHECK(d.says("of7runsdone"));
  d.click(d.find("Goon"));
  REQUIRE(d.until([&] { return d.desk().status.stage == StudyStage::finished; }));
  CHECK(d.desk().results->rows.size() == 7);
}

TEST_CASE("the cheapest setting below an error is used in one click, and is then in use") {
  Drawer d(bar());
  d.make_quick();
  d.click(d.find("Start"));
  REQUIRE(d.until([&] { return d.desk().status.stage == StudyStage::finished; }));
  CHECK(d.says("Cheapestforanerrorbelow"));
  const auto range = error_range(*d.desk().results->study, d.desk().results->rows);
  d.desk().tolerance = 1.001 * range->first;
  const auto strict = d.desk().answer();
  REQUIRE(strict);
  CHECK(strict->best->error_l2 <= 1.001 * range->first);
  d.click(d.find("Useit"));
  CHECK(d.desk().place->setting(*d.desk().results->study) == strict->best->point);
  CHECK(d.says("Inuse"));
  d.desk().tolerance = 0.5 * range->first;
  CHECK_FALSE(d.desk().answer());
  CHECK(d.says("Norunisthatexact"));
}

TEST_CASE("a map is set up, fills, and a click on a cell opens its setting") {
  Scene scene = bar();
  scene.exact_position.clear();
  Drawer d(scene);
  d.click(d.find("Stabilitymap"));
  CHECK(d.desk().draft.kind == StudyKind::stability_map);
  d.desk().draft.axes = {{"/time/step", {0.001, 0.002, 0.004, 0.008}}, {"/materials/bar/young", {1e4, 1e5, 1e6}}};
  d.desk().draft.end = 0.04;
  d.click(d.find("Start"));
  REQUIRE(d.until([&] { return d.desk().status.stage == StudyStage::finished; }));
  REQUIRE(d.desk().figures.size() == 1);
  CHECK(d.desk().figures[0].cell.size() == 12);
  CHECK(d.says("youarehere"));
  check(d);
  const Study& study = *d.desk().results->study;
  std::set<std::size_t> opened;
  for (const float across : {0.5F, 0.8F}) {
    d.click({320 + across * (d.size.x - 320), 0.35F * d.size.y});
    REQUIRE(d.desk().place);
    const auto setting = d.desk().place->setting(study);
    REQUIRE(setting);
    opened.insert(*setting);
    const std::vector<std::size_t> at = study_point(study, *setting).at;
    const auto value = [&](std::size_t axis) { return study.axes[axis].values[at[axis]].edits.front().value; };
    CHECK(d.h.context.scene.time.step == value(0).get<double>());
    CHECK(to_json(d.h.context.scene)["materials"]["bar"]["young"] == value(1));
  }
  CHECK(opened.size() == 2);
}

TEST_CASE("every state shows all of its text at every size, without overlap") {
  for (const float scale : {1.0F, 2.0F})
    for (const ImVec2 size : {ImVec2(1000, 2400), ImVec2(740, 2400), ImVec2(1640, 2400)})
      for (const StudyKind kind : {StudyKind::work_precision, StudyKind::stability_map}) {
        CAPTURE(scale);
        CAPTURE(size.x);
        CAPTURE(static_cast<int>(kind));
        Scene scene = bar();
        if (kind == StudyKind::stability_map) scene.exact_position.clear();
        Drawer d(scene, scale, size);
        d.desk().propose(d.h.context, kind);
        d.make_quick();
        check(d);
        CHECK(cut_off(d.show()) == "");
        d.desk().start_draft(scene);
        check(d);
        REQUIRE(d.until([&] { return d.desk().status.stage == StudyStage::finished; }));
        for (const bool list : {false, true})
          for (std::size_t k = 0; k < d.desk().figures.size(); ++k) {
            d.desk().show_list = list;
            d.desk().figure = k;
            check(d);
            CHECK(cut_off(d.show()) == "");
          }
      }
}

TEST_CASE("a study that cannot be read says why and lets another one be made") {
  Drawer d(bar());
  d.desk().open({R"({"scene": "nowhere", "vary": {"/time/step": [1]}})", "broken.json", "."});
  REQUIRE(d.until([&] { return d.desk().status.stage == StudyStage::failed; }));
  CHECK(d.says("cannotberun"));
  d.click(d.find("Newstudy"));
  CHECK(d.says("Vary"));
}
