// A study is proposed for any scene, and what is proposed can be run.
#include "app/studies/draft.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/studies/library.hpp"
#include "core/assets.hpp"
#include "core/scene/scene_io.hpp"
#include "core/studies/driver.hpp"
#include "core/studies/study_charts.hpp"
#include "core/studies/study_io.hpp"
#include "tests/studies/small_study.hpp"

using namespace pf;
using namespace pf::app;

namespace {

constexpr double millisecond = 1e-3;

Scene bar() {
  return parse_scene(test::bar_scene, "bar");
}

Study study_of(const StudyDraft& draft, const Scene& scene) {
  return parse_study(study_text(draft, scene), "draft", ".");
}

bool varies(const StudyDraft& draft, const std::string& pointer) {
  return std::any_of(draft.axes.begin(), draft.axes.end(), [&](const DraftAxis& a) { return a.pointer == pointer; });
}

}  // namespace

TEST_CASE("both kinds of study are proposed for every shipped scene, and are sound") {
  for (const auto& entry : std::filesystem::directory_iterator(asset_path("scenes"))) {
    if (entry.path().extension() != ".json") continue;
    CAPTURE(entry.path().string());
    const Scene scene = load_scene(entry.path());
    for (const StudyKind kind : {StudyKind::work_precision, StudyKind::stability_map}) {
      const StudyDraft draft = propose_study(scene, kind, 2 * millisecond);
      CHECK(draft_problem(draft, scene) == "");
      CHECK(draft.end <= scene.time.end);
      const Study study = study_of(draft, scene);
      CHECK(study.kind == kind);
      CHECK(study_size(study) == size_of(draft, scene).runs);
      CHECK(study_size(study) >= 8);
      CHECK(study_size(study) <= 80);
      if (kind == StudyKind::work_precision) CHECK(study.reference != ReferenceKind::none);
      for (std::size_t k = 0; k < study_size(study); ++k)
        CHECK(study_scene(study, study_point(study, k)).time.end <= draft.end);
    }
  }
}

TEST_CASE("a known motion is the reference; else a fine run with shorter steps than all") {
  const StudyDraft known = propose_study(bar(), StudyKind::work_precision, millisecond);
  CHECK(known.reference == ReferenceKind::exact);
  CHECK(varies(known, "/integrator/type"));
  CHECK(varies(known, "/time/step"));
  Scene unknown = bar();
  unknown.exact_position.clear();
  StudyDraft draft = propose_study(unknown, StudyKind::work_precision, millisecond);
  CHECK(draft.reference == ReferenceKind::run);
  draft.axes.push_back({"/grid/spacing", {0.25, 0.125}});
  const Study study = study_of(draft, unknown);
  const Scene fine = reference_scene(study);
  for (std::size_t k = 0; k < study_size(study); ++k) {
    const Scene run = study_scene(study, study_point(study, k));
    CHECK(fine.time.step < run.time.step);
    CHECK(fine.grid.spacing < run.grid.spacing);
  }
  CHECK(study.samples == 5);  // the proposed steps meet five times
}

TEST_CASE("what cannot be begun says why") {
  StudyDraft draft = propose_study(bar(), StudyKind::work_precision, millisecond);
  CHECK(draft_problem(draft, bar()) == "");
  StudyDraft twice = draft;
  twice.axes.push_back(twice.axes.front());
  CHECK(draft_problem(twice, bar()).find("twice") != std::string::npos);
  StudyDraft stiff = draft;
  stiff.axes.push_back(proposed_axis(bar(), "/materials/bar/young", draft.kind));
  CHECK(draft_problem(stiff, bar()).find("reference") != std::string::npos);
  draft.axes.clear();
  CHECK(draft_problem(draft, bar()) != "");
  StudyDraft map = propose_study(bar(), StudyKind::stability_map, millisecond);
  map.axes.pop_back();
  CHECK(draft_problem(map, bar()).find("two settings") != std::string::npos);
}

TEST_CASE("only what can change the motion is offered") {
  const std::vector<std::string> all = variable_settings(bar());
  const auto offered = [&](const char* pointer) { return std::find(all.begin(), all.end(), pointer) != all.end(); };
  for (const char* pointer : {"/time/step", "/grid/spacing", "/grid/basis", "/integrator/type", "/transfer/type",
                              "/transfer/flip_ratio", "/materials/bar/young", "/bodies/0/particles_per_axis"})
    CHECK_MESSAGE(offered(pointer), pointer);
  for (const std::string& pointer : all)
    for (const char* other : {"/view", "/time/end", "/time/frame", "/shape/", "/constants", "/name"})
      CHECK_MESSAGE(pointer.find(other) == std::string::npos, pointer);
  Scene apic = bar();
  apic.transfer.type = "apic";
  const std::vector<std::string> less = variable_settings(apic);
  CHECK(std::find(less.begin(), less.end(), "/transfer/flip_ratio") == less.end());
}

TEST_CASE("runs are shortened until the whole study takes about a minute, and the same however the clock jitters") {
  Scene scene = bar();
  scene.time.end = 100;
  const StudyDraft draft = propose_study(scene, StudyKind::work_precision, 5 * millisecond);
  CHECK(draft.end < 100);
  const double seconds = size_of(draft, scene).steps * 5 * millisecond;
  CHECK(seconds <= 66);
  CHECK(seconds >= 25);
  CHECK(propose_study(scene, StudyKind::work_precision, 5.1 * millisecond).end == draft.end);
}

TEST_CASE("a map of time step and stiffness has the explicit limit drawn over it") {
  const StudyDraft draft = propose_study(bar(), StudyKind::stability_map, millisecond);
  const Study study = study_of(draft, bar());
  REQUIRE(study.limits.size() == 1);
  StudyDriver driver(study, {});
  for (int k = 0; k < 4; ++k) driver.advance(nullptr);  // the corners
  const StudyFigure figure = study_figures(study, driver.rows()).front();
  const Series& limit = figure.chart.series.front();
  // c = sqrt(E/rho), c dt = dx: dt = 0.125 sqrt(1000/E).
  int seen = 0;
  for (std::size_t k = 0; k < limit.x.size(); ++k) {
    if (!(limit.x[k] > 0)) continue;
    CHECK(limit.x[k] == doctest::Approx(0.125 * std::sqrt(1000 / limit.y[k])).epsilon(1e-3));
    ++seen;
  }
  CHECK(seen > 100);
}
