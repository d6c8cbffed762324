// How far a run is, on stderr: a bar on a terminal, a line now and then elsewhere; warnings as they come.
#pragma once

#include <chrono>
#include <set>
#include <string>

#include "core/runner.hpp"

namespace pf::app {

class Progress : public RunObserver {
 public:
  /// `steps`: the run stops after this many; `quiet`: warnings only.
  Progress(std::optional<long> steps, bool quiet);
  void on_state(const Simulation& simulation) override;
  void on_end(const Simulation& simulation, const RunResult& result) override;

 private:
  using Clock = std::chrono::steady_clock;
  void warn(const StepReport& report);
  double fraction(const Simulation& simulation) const;
  std::string line(const Simulation& simulation, double seconds) const;
  void clear_bar();

  std::optional<long> steps_;
  bool quiet_;
  bool terminal_;
  bool bar_shown_ = false;
  bool begun_ = false;
  Clock::time_point start_ = Clock::now(), last_ = start_;
  double first_time_ = 0;
  long first_step_ = 0;
  std::set<std::string> warned_;
};

/// "1:02:03", "2:03", "12 s".
std::string clock_text(double seconds);

}  // namespace pf::app
