// What the advisor says of runs whose answer is known beforehand, and that its trials are what they say they are.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "core/advice/advice.hpp"
#include "core/advice/rules.hpp"
#include "core/params/problem.hpp"
#include "tests/simulation/scenes.hpp"

using namespace pf;
using namespace pf::test;

namespace {

TrialStart start_of(const Simulation& simulation) {
  return {.scene = std::make_shared<const Scene>(simulation.scene()), .state = state_of(simulation), .step = 0};
}

AdviceReport judged(const Json& scene, int steps) {
  const auto simulation = start(scene);
  run(*simulation, steps);
  std::optional<AdviceReport> report = advise(start_of(*simulation));
  REQUIRE(report);
  REQUIRE_MESSAGE(report->why_none.empty(), report->why_none);
  return *std::move(report);
}

const Trial* advised(const AdviceReport& report, const std::string& rule) {
  for (const std::size_t k : report.advice)
    if (report.trials[k].rule == rule) return &report.trials[k];
  return nullptr;
}

/// A bar that is held at its left end and swings along itself after a small push.
Json bar(double step) {
  Json scene = block();
  scene["time"]["step"] = step;
  scene["bodies"][0]["shape"] = box({0, 0}, {1, 0.2});
  scene["bodies"][0]["velocity"] = {"0.1*sin(pi*X/2)", 0};
  scene["constraints"] = Json::array({{{"region", box({-0.05, -1}, {0.01, 1})}, {"fix", {true, true}}}});
  return scene;
}

}  // namespace

TEST_CASE("advice: steps far shorter than the grid is exact are found out, longer ones and explicit ones cost less") {
  // The wave crosses a cell in 9 ms.
  const AdviceReport report = judged(bar(2e-5), 10);
  const Trial& now = report.trials.front();
  CHECK(report.grid_open > 0);
  const Trial* longer = advised(report, "steps");
  REQUIRE(longer);
  CHECK(longer->edits.front().value.get<double>() == doctest::Approx(8 * 2e-5));
  CHECK(longer->work < 0.4 * now.work);
  CHECK(longer->error <= 1.2 * now.error);
  const Trial* explicitly = advised(report, "explicit");
  REQUIRE(explicitly);
  CHECK(explicitly->work < 0.5 * now.work);
  // What saves most comes first.
  for (std::size_t k = 1; k < report.advice.size(); ++k)
    CHECK(report.trials[report.advice[k - 1]].work <= report.trials[report.advice[k]].work);
}

TEST_CASE("advice: what is said of a trial is what a run with its settings does") {
  const auto simulation = start(bar(5e-4));
  run(*simulation, 6);
  const TrialStart from = start_of(*simulation);
  const std::optional<AdviceReport> report = advise(from);
  REQUIRE(report);
  const auto end_with = [&](const std::vector<Edit>& edits) {
    const auto again = make_simulation(*from.scene, {1});
    std::istringstream in(from.state);
    again->load_state(in);
    REQUIRE(again->apply(edited(*from.scene, edits)));
    // Where a long step does not go over their ends, at the quarters of the span, too.
    std::vector<std::vector<ParticleState>> course;
    const int stops = again->scene().time.step * 4 <= report->span * (1 + 1e-9) ? 4 : 1;
    for (int k = 1; k <= stops; ++k) {
      again->set_end(report->time + static_cast<double>(k) / stops * report->span);
      while (again->step().status == StepStatus::accepted) {
      }
      course.push_back(again->particles());
    }
    return course;
  };
  const auto rms = [](const std::vector<ParticleState>& a, const std::vector<ParticleState>& b) {
    double sum = 0, mass = 0;
    for (std::size_t p = 0; p < a.size(); ++p) {
      sum += a[p].mass * (a[p].x - b[p].x).squaredNorm();
      mass += a[p].mass;
    }
    return std::sqrt(sum / mass);
  };
  const std::vector<Edit> fine{{"/integrator/type", "tr_bdf2"},
                               {"/time/step", from.scene->time.step / 4},
                               {"/solver/newton_tolerance", 1e-8},
                               {"/transfer", {{"type", "flip"}, {"flip_ratio", 1}}}};
  const auto exact = end_with(fine);
  int compared = 0;
  for (const Trial& trial : report->trials) {
    if (!trial.came_through || trial.rule == "rest") continue;
    CAPTURE(trial.title);
    const auto course = end_with(trial.edits);
    double distance = 0;
    for (std::size_t k = 1; k <= course.size(); ++k)
      distance = std::max(distance, rms(course[course.size() - k], exact[exact.size() - k]));
    CHECK(distance == doctest::Approx(trial.distance).epsilon(1e-9));
    CHECK(trial.error == trial.distance + report->reference_open + report->grid_open);
    ++compared;
  }
  CHECK(compared > 5);
}

TEST_CASE("advice: a run whose error the step decides is told no longer steps of its integrator") {
  Json coarse = bar(0.03);
  coarse["grid"]["spacing"] = 0.05;
  const AdviceReport report = judged(coarse, 3);
  const Trial& now = report.trials.front();
  REQUIRE(now.distance > 2 * (report.grid_open + report.reference_open));
  CHECK(advised(report, "steps") == nullptr);
  // A second-order one is more exact for the same work, or as exact for less.
  const Trial* other = advised(report, "integrator");
  REQUIRE(other);
  CHECK((other->work <= 0.9 * now.work || other->error <= 0.5 * now.error));
}

TEST_CASE("advice: a basis larger than the grid makes use of, a tolerance tighter than anything shows") {
  Json scene = bar(1e-3);
  scene["grid"]["basis"] = "cubic";
  scene["solver"]["newton_tolerance"] = 1e-10;
  const AdviceReport report = judged(scene, 5);
  const Trial* basis = advised(report, "basis");
  REQUIRE(basis);
  CHECK(basis->work < 0.9 * report.trials.front().work);
  CHECK(report.other_basis == "quadratic");
  const Trial* newton = advised(report, "newton");
  REQUIRE(newton);
  CHECK(newton->work < report.trials.front().work);
}

TEST_CASE("advice: an explicit run far above its needs is told of implicit steps") {
  // Very stiff, and pulled by gravity alone: the motion is slow.
  Json scene = block();
  scene["materials"]["rubber"]["young"] = 1e9;
  scene["gravity"] = {0, -9.81};
  scene["integrator"] = {{"type", "symplectic_euler"}};
  scene["time"]["step"] = 2e-5;
  const AdviceReport report = judged(scene, 5);
  const Trial* implicitly = advised(report, "implicit");
  REQUIRE(implicitly);
  CHECK(implicitly->work < 0.9 * report.trials.front().work);
}

TEST_CASE("advice: what rests may end; what moves may not") {
  Json scene = block();
  const AdviceReport still = judged(scene, 2);
  CHECK(still.resting == 1);
  const Trial* rest = advised(still, "rest");
  REQUIRE(rest);
  CHECK(rest->edits == std::vector<Edit>{{"/time/end", still.time}});
  scene["bodies"][0]["velocity"] = {1, 0};
  scene["bodies"].push_back({{"material", "rubber"}, {"shape", box({1.0, 0.1}, {1.4, 0.5})}});
  const AdviceReport half = judged(scene, 2);
  CHECK(half.resting == doctest::Approx(0.5));
  CHECK(advised(half, "rest") == nullptr);
}

TEST_CASE("advice: every rule proposes settings that apply to the running simulation") {
  Json scene = bar(1e-3);
  scene["grid"]["boundary_correction"] = true;
  scene["integrator"]["mass"] = "consistent";
  scene["transfer"] = {{"type", "flip"}, {"velocity_mass", "consistent"}};
  scene["solver"]["linear"] = "pcg_jacobi";
  scene["materials"]["rubber"]["f_bar"] = true;
  const auto simulation = start(scene);
  run(*simulation, 1);
  std::size_t proposals = 0;
  for (const char* integrator : {"backward_euler", "symplectic_euler", "quasi_static"}) {
    const Scene changed = edited(simulation->scene(), std::vector<Edit>{{"/integrator/type", integrator}});
    for (const AdviceRule& rule : advice_rules()) {
      CAPTURE(rule.name);
      CHECK(rule.sentence.find("{}") != std::string_view::npos);
      for (const Proposal& proposal :
           rule.propose({.scene = changed, .step = 1e-3, .explicit_limit = 5e-3, .largest_strain = 1e-3})) {
        CAPTURE(proposal.title);
        const Scene next = edited(changed, proposal.edits);
        CHECK(next != changed);
        CHECK(simulation->apply(next));
        CHECK(edited(next, inverse(changed, proposal.edits)) == changed);
        ++proposals;
      }
    }
  }
  CHECK(proposals > 20);
}

TEST_CASE("advice: the same for any number of threads, and given up at once when cancelled") {
  const auto simulation = start(bar(1e-3));
  run(*simulation, 3);
  const TrialStart from = start_of(*simulation);
  const std::string before = state_of(*simulation);
  const std::optional<AdviceReport> one = advise(from, {.threads = 1}), two = advise(from, {.threads = 2});
  REQUIRE(one);
  REQUIRE(two);
  REQUIRE(one->trials.size() == two->trials.size());
  for (std::size_t k = 0; k < one->trials.size(); ++k) {
    CHECK(one->trials[k].distance == two->trials[k].distance);
    CHECK(one->trials[k].work == two->trials[k].work);
  }
  CHECK(one->advice == two->advice);
  CHECK(state_of(*simulation) == before);
  const std::atomic<bool> cancel{true};
  CHECK_FALSE(advise(from, {}, &cancel));
  // Progress rises to its end.
  double last = 0;
  advise(from, {}, nullptr, [&](double share) {
    CHECK(share >= last);
    CHECK(share <= 1 + 1e-12);
    last = share;
  });
  CHECK(last == doctest::Approx(1));
}

TEST_CASE("advice: the state of another scene is refused") {
  const auto simulation = start(bar(1e-3));
  TrialStart from = start_of(*simulation);
  from.scene = std::make_shared<const Scene>(parse_scene(block().dump(), "test"));
  CHECK_THROWS_AS(advise(from), InputError);
}
