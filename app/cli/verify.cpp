// pushforward verify: cases with known answers (assets/verification, studies with checks).
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/cli/commands.hpp"
#include "app/cli/interrupt.hpp"
#include "core/assets.hpp"
#include "core/build_info.hpp"
#include "core/files.hpp"
#include "core/params/nearest.hpp"
#include "core/params/problem.hpp"
#include "core/studies/checks.hpp"
#include "core/studies/driver.hpp"
#include "core/studies/study_charts.hpp"
#include "core/studies/study_io.hpp"

namespace pf::app {

namespace {

namespace fs = std::filesystem;

struct Case {
  std::string name;
  Study study;
};

/// `folder` of the assets: "verification", or "failures": where methods fail, and what cures it.
std::vector<fs::path> shipped_cases(const char* folder) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const fs::path& root : asset_roots())
    for (const auto& entry : fs::directory_iterator(root / folder, ignored))
      if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::ranges::sort(files, {}, [](const fs::path& file) { return file.stem(); });
  const auto same_name = [](const fs::path& a, const fs::path& b) { return a.stem() == b.stem(); };
  files.erase(std::unique(files.begin(), files.end(), same_name), files.end());
  return files;
}

/// Those of the names, files or shipped cases; where there are no names, all that verify. "quick" stands for the short
/// ones of these, "failures" for all that show a failure and its cure.
std::vector<Case> find_cases(const std::vector<std::string>& names) {
  const std::vector<fs::path> verifying = shipped_cases("verification"), failing = shipped_cases("failures");
  std::vector<fs::path> shipped = verifying;
  shipped.insert(shipped.end(), failing.begin(), failing.end());
  std::vector<Case> cases;
  const auto add = [&](const fs::path& file) { cases.push_back({file.stem().string(), load_study(file)}); };
  if (names.empty()) std::ranges::for_each(verifying, add);
  for (const std::string& name : names) {
    if (name == "quick") {
      for (const fs::path& file : verifying)
        if (load_study(file).quick) add(file);
      continue;
    }
    if (name == "failures") {
      std::ranges::for_each(failing, add);
      continue;
    }
    std::error_code ignored;
    const auto found = std::ranges::find(shipped, name, [](const fs::path& file) { return file.stem().string(); });
    if (found != shipped.end()) {
      add(*found);
    } else if (fs::is_regular_file(name, ignored)) {
      add(name);
    } else {
      std::vector<std::string> known = {"quick", "failures"};
      for (const fs::path& file : shipped) known.push_back(file.stem().string());
      const std::string near = nearest_name(name, known);
      throw FileError(name + ": there is no such case or file" +
                      (near.empty() ? "; see pushforward verify --list" : "; did you mean " + near + "?"));
    }
  }
  for (const Case& c : cases)
    if (c.study.checks.empty())
      throw InputError(c.study.source, {Problem{"/checks", "no checks", "at least one: what must come out", 0}});
  return cases;
}

void list(const std::vector<Case>& cases) {
  std::size_t width = 0;
  for (const Case& c : cases) width = std::max(width, c.name.size());
  for (const Case& c : cases)
    std::printf("%-*s  %s%s\n", static_cast<int>(width), c.name.c_str(), c.study.about.c_str(),
                c.study.quick ? " [quick]" : "");
}

nlohmann::ordered_json json_of(const StudyCheck& check, const CheckResult& result) {
  nlohmann::ordered_json j{{"name", check.name}, {"passed", result.passed}, {"value", result.worst}};
  j["values"] = result.values;
  if (check.above) j["above"] = *check.above;
  if (check.below) j["below"] = *check.below;
  if (!check.peer.empty()) j["peer"] = check.peer;
  if (!result.reason.empty()) j["reason"] = result.reason;
  return j;
}

void print(const StudyCheck& check, const CheckResult& result) {
  std::printf("  %s  %-52s %11.4g  %-16s", result.passed ? "pass" : "FAIL", check.name.c_str(), result.worst,
              bounds_text(check).c_str());
  if (!check.peer.empty()) std::printf("  peer: %s", check.peer.c_str());
  if (!result.reason.empty()) std::printf("  (%s)", result.reason.c_str());
  std::printf("\n");
}

/// Nothing where the user interrupted it.
std::optional<nlohmann::ordered_json> run(const Case& c, const fs::path& out, const std::atomic<bool>& cancel) {
  const auto begin = std::chrono::steady_clock::now();
  StudyDriver driver(c.study, {.folder = out, .cache = cache_folder() / "references", .fresh = true});
  const int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  if (!driver.prepare(&cancel) || !driver.run(jobs, &cancel)) return std::nullopt;
  const std::vector<StudyRow> rows = driver.rows();
  if (!out.empty()) write_figures(study_figures(driver.study(), rows), driver.study(), out);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::printf("%s: %s (%zu runs, %.1f s)\n", c.name.c_str(), c.study.name.c_str(), rows.size(), seconds);
  nlohmann::ordered_json result{{"case", c.name},         {"name", c.study.name},
                                {"about", c.study.about}, {"source", c.study.reference_text},
                                {"runs", rows.size()},    {"seconds", seconds}};
  bool passed = true;
  for (const StudyCheck& check : c.study.checks) {
    const CheckResult found = evaluate(c.study, check, rows);
    print(check, found);
    result["checks"].push_back(json_of(check, found));
    passed = passed && found.passed;
  }
  std::fflush(stdout);
  result["passed"] = passed;
  return result;
}

}  // namespace

int verify(const VerifyOptions& options) {
  const std::vector<Case> cases = find_cases(options.cases);
  if (options.list) return list(cases), exit_done;
  const InterruptGuard interrupt;
  nlohmann::ordered_json all{{"format", "pushforward/verification"}, {"version", 1}, {"build", build_info().version}};
  all["cases"] = nlohmann::ordered_json::array();
  std::size_t failed = 0, checks = 0;
  double seconds = 0;
  bool interrupted = false;
  for (const Case& c : cases) {
    const auto result = run(c, options.out.empty() ? fs::path() : options.out / c.name, interrupt.flag());
    if (!result) {
      interrupted = true;
      break;
    }
    failed += (*result)["passed"].get<bool>() ? 0 : 1;
    checks += c.study.checks.size();
    seconds += (*result)["seconds"].get<double>();
    all["cases"].push_back(*result);
  }
  if (options.json) write_atomically(*options.json, all.dump(2) + '\n');
  if (interrupted) return exit_interrupted;
  std::printf("%zu of %zu cases passed, %zu checks, %.0f s\n", cases.size() - failed, cases.size(), checks, seconds);
  return failed > 0 ? exit_comparison_failed : exit_done;
}

}  // namespace pf::app
