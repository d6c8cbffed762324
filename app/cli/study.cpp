// pushforward study: sweeps, resumed where they were; charts and the cheapest settings.
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "app/cli/commands.hpp"
#include "app/cli/interrupt.hpp"
#include "app/cli/progress.hpp"
#include "core/assets.hpp"
#include "core/files.hpp"
#include "core/params/nearest.hpp"
#include "core/params/problem.hpp"
#include "core/studies/adaptive_front.hpp"
#include "core/studies/driver.hpp"
#include "core/studies/results.hpp"
#include "core/studies/study_charts.hpp"
#include "core/studies/study_io.hpp"

namespace pf::app {

namespace {

namespace fs = std::filesystem;

// A file, or the name of a shipped study.
fs::path find_study(const std::string& name) {
  std::error_code ignored;
  if (fs::exists(name, ignored)) return name;
  std::vector<std::string> shipped;
  for (const fs::path& root : asset_roots())
    for (const auto& entry : fs::directory_iterator(root / "studies", ignored)) {
      if (entry.path().extension() != ".json") continue;
      if (entry.path().stem() == name) return entry.path();
      shipped.push_back(entry.path().stem().string());
    }
  const std::string near = nearest_name(fs::path(name).stem().string(), shipped);
  throw FileError(name + ": there is no such file" +
                  (near.empty() ? "" : "; did you mean the shipped study " + near + "?"));
}

std::string setting_text(const Study& study, const StudyRow& row) {
  const std::vector<std::string> columns = varied_columns(study);
  const auto values = varied_values(study, study_point(study, row.point));
  std::string text;
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (!values[k].is_null()) text += (text.empty() ? "" : "  ") + columns[k] + "=" + values[k].dump();
  return text;
}

// One line a row: what was run and what came of it.
void tell(const StudyDriver& driver, const StudyRow& row) {
  char numbers[160];
  const Cost cost = cost_of(driver.study(), row);
  std::snprintf(numbers, sizeof numbers, "%s  cost %.3g", std::string(name_of(row.behaviour)).c_str(), cost.value);
  std::string line = "[" + std::to_string(driver.finished()) + "/" + std::to_string(driver.size()) + "] " +
                     setting_text(driver.study(), row) + ": " + numbers;
  if (!std::isnan(row.error_l2)) {
    std::snprintf(numbers, sizeof numbers, "  error %.3g m", row.error_l2);
    line += numbers;
  }
  if (!row.reason.empty()) line += "  (" + row.reason.substr(0, 100) + (row.reason.size() > 100 ? "...)" : ")");
  const double left = driver.seconds_left();
  if (left > 0) line += "  " + clock_text(left) + " left";
  std::fprintf(stderr, "%s\n", line.c_str());
}

void finish(const StudyDriver& driver, const fs::path& folder) {
  const std::vector<StudyRow> rows = driver.rows();
  write_figures(study_figures(driver.study(), rows), driver.study(), folder);
  if (driver.study().kind == StudyKind::work_precision)
    write_atomically(folder / "best.json", best_document(driver.study(), rows).dump(2) + '\n');
  if (const std::string csv = adaptive_csv(driver.study(), rows); !csv.empty())
    write_atomically(folder / "adaptive.csv", csv);
}

int run_one(const std::string& name, const StudyRunOptions& options, const fs::path& folder,
            const std::atomic<bool>& cancel) {
  Study study = load_study(find_study(name));
  StudyDriver driver(std::move(study),
                     {.folder = folder, .cache = cache_folder() / "references", .fresh = options.fresh});
  const std::string title = driver.study().name.empty() ? name : driver.study().name;
  if (!options.quiet) {
    std::fprintf(stderr, "%s: %zu runs", title.c_str(), driver.size());
    if (driver.resumed() > 0) std::fprintf(stderr, ", %zu of them done before", driver.resumed());
    if (driver.study().cost == "wall" && options.jobs > 1) std::fprintf(stderr, "; timed, so one at a time");
    std::fprintf(stderr, "\n");
  }
  double told = 0;
  const bool prepared = driver.prepare(&cancel, [&](double share) {
    if (options.quiet || share < told + 0.25) return;
    told = share;
    std::fprintf(stderr, "fine run for reference: %.0f %%\n", 100 * share);
  });
  const bool complete = prepared && driver.run(options.jobs, &cancel, [&](const StudyRow& row) {
    if (!options.quiet) tell(driver, row);
  });
  finish(driver, folder);
  if (!complete) {
    std::fprintf(stderr, "interrupted with %zu of %zu runs done; the same command goes on from here\n",
                 driver.finished(), driver.size());
    return exit_interrupted;
  }
  if (!options.quiet) {
    std::size_t counts[6] = {};
    for (const StudyRow& row : driver.rows()) ++counts[static_cast<std::size_t>(row.behaviour)];
    std::printf("%s: %zu runs", title.c_str(), driver.size());
    for (std::size_t k = 0; k < 6; ++k)
      if (counts[k] > 0) std::printf(", %zu %s", counts[k], std::string(name_of(static_cast<RunClass>(k))).c_str());
    std::printf("; %s\n", (folder / "results.csv").c_str());
  }
  return exit_done;
}

}  // namespace

int run_studies(const StudyRunOptions& options) {
  for (const std::string& name : options.studies) load_study(find_study(name));  // all are sound before the first runs
  const InterruptGuard interrupt;
  for (const std::string& name : options.studies) {
    const fs::path folder = options.studies.size() == 1 ? options.out : options.out / fs::path(name).stem();
    const int status = run_one(name, options, folder, interrupt.flag());
    if (status != exit_done) return status;
  }
  return exit_done;
}

}  // namespace pf::app
