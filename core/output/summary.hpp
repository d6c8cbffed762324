// summary.json: what a run was and what came of it, complete enough to repeat it.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/runner.hpp"

namespace pf {

/// Peak resident memory of this process [bytes]; 0 where the system does not say.
std::uint64_t peak_memory();
/// The processor's name, "" where the system does not say.
std::string processor_name();

/// What all steps of a run add up to.
struct RunTotals {
  long steps = 0, newton_iterations = 0, linear_iterations = 0, retries = 0;
  PhaseTimes ms;
  Work work;
  double min_J = 1, max_J = 1;
  std::map<std::string, long> warnings;  ///< text -> how often
  void add(const StepReport& report);
};

/// Gathers totals; writes the file at the end, whatever the end was.
class SummaryWriter : public RunObserver {
 public:
  /// `scene` as run (every override applied); `threads` as asked for, 0: all; file "" writes nothing.
  SummaryWriter(std::filesystem::path file, Scene scene, int threads);
  void on_state(const Simulation& simulation) override;
  void on_end(const Simulation& simulation, const RunResult& result) override;
  const RunTotals& totals() const { return totals_; }
  /// One line for people: what was run, how long it took.
  std::string line(const Simulation& simulation, const RunResult& result) const;

 private:
  nlohmann::ordered_json document(const Simulation& simulation, const RunResult& result) const;

  std::filesystem::path file_;
  Scene scene_;
  int threads_;
  RunTotals totals_;
  bool begun_ = false;
  long first_step_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double wall_ = 0;  ///< [s], at the end
};

}  // namespace pf
