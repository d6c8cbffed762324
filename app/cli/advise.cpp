// pushforward advise: what of a scene's settings could be cheaper, and how that was measured.
#include <algorithm>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "app/advice/words.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/interrupt.hpp"
#include "core/advice/advice.hpp"
#include "core/files.hpp"
#include "core/runner.hpp"
#include "core/scene/scene_io.hpp"

namespace pf::app {

namespace {

nlohmann::ordered_json json_of(const Trial& trial) {
  nlohmann::ordered_json j{{"rule", trial.rule}, {"title", trial.title}, {"came_through", trial.came_through}};
  j["set"] = nlohmann::ordered_json::object();
  for (const Edit& edit : trial.edits) j["set"][edit.pointer] = edit.value;
  j["steps"] = trial.steps;
  j["work"] = trial.work;
  j["wall_ms"] = trial.wall_ms;
  if (!trial.came_through) {
    j["trouble"] = trial.trouble;
    return j;
  }
  j["error"] = trial.error;
  j["distance"] = trial.distance;
  return j;
}

nlohmann::ordered_json json_of(const AdviceReport& report, const Scene& scene) {
  nlohmann::ordered_json j{{"scene", scene.name},
                           {"time", report.time},
                           {"span", report.span},
                           {"grid_open", report.grid_open},
                           {"other_basis", report.other_basis},
                           {"reference_open", report.reference_open},
                           {"resting", report.resting},
                           {"why_none", report.why_none}};
  j["trials"] = nlohmann::ordered_json::array();
  for (const Trial& trial : report.trials) j["trials"].push_back(json_of(trial));
  j["advice"] = report.advice;
  return j;
}

void print(const AdviceReport& report) {
  for (const std::string& text : {basis_of_judgement(report), resting_words(report)})
    if (!text.empty()) std::printf("%s\n", text.c_str());
  std::size_t width = 8;
  for (const Trial& trial : report.trials) width = std::max(width, trial.title.size());
  std::printf("\n%-*s  %8s  %10s  %12s  %12s\n", static_cast<int>(width), "trial", "steps", "work", "error [m]",
              "time [ms]");
  const double as_it_is = report.trials.front().work;
  for (const Trial& trial : report.trials) {
    std::printf("%-*s  %8ld  ", static_cast<int>(width), trial.title.c_str(), trial.steps);
    if (trial.came_through)
      std::printf("%10.3f  %12.3g  %12.1f\n", as_it_is > 0 ? trial.work / as_it_is : 1, trial.error, trial.wall_ms);
    else
      std::printf("%s\n", trial.trouble.c_str());
  }
  std::printf("\n");
  if (const std::string none = no_advice(report); !none.empty()) std::printf("%s\n", none.c_str());
  for (const std::size_t k : report.advice) {
    const Trial& trial = report.trials[k];
    std::printf("%s.\n  %s\n ", trial.sentence.c_str(), evidence(report, trial).c_str());
    for (const Edit& edit : trial.edits)
      std::printf(" --set %s=%s", edit.pointer.c_str(),
                  edit.value.is_string() ? edit.value.get<std::string>().c_str() : edit.value.dump().c_str());
    std::printf("\n");
  }
}

}  // namespace

int advise_on(const AdviseOptions& options) {
  const Scene scene = load_scene(find_scene(options.scene), parse_sets(options.sets));
  const int threads = options.threads.value_or(static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
  const std::unique_ptr<Simulation> simulation = make_simulation(scene, {.threads = threads, .file = options.scene});
  const InterruptGuard interrupt;
  simulation->set_end(options.at.value_or(scene.time.end / 2));
  const RunResult result = Runner(*simulation).run({}, &interrupt.flag());
  if (result.end == RunEnd::interrupted) return exit_interrupted;
  if (result.end == RunEnd::failed) {
    std::fprintf(stderr, "%s\n", result.last_attempt.failure.c_str());
    return exit_simulation_failed;
  }
  TrialStart start{
      .scene = std::make_shared<const Scene>(simulation->scene()), .state = {}, .step = simulation->report().dt};
  std::ostringstream state;
  simulation->save_state(state);
  start.state = std::move(state).str();
  const std::optional<AdviceReport> report = advise(start, {.threads = threads}, &interrupt.flag());
  if (!report) return exit_interrupted;
  print(*report);
  if (options.json) write_atomically(*options.json, json_of(*report, scene).dump(2) + "\n");
  return exit_done;
}

}  // namespace pf::app
