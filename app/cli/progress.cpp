#include "app/cli/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pf::app {

namespace {

constexpr double bar_interval = 0.1, line_interval = 10;  // [s]
constexpr int bar_width = 24;
constexpr int most_warnings = 20;  // shown one by one; summary.json has them all

}  // namespace

std::string clock_text(double seconds) {
  const long whole = std::lround(std::max(0.0, seconds));
  char text[48];
  if (whole < 60)
    std::snprintf(text, sizeof text, "%ld s", whole);
  else if (whole < 3600)
    std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
  else
    std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
  return text;
}

Progress::Progress(std::optional<long> steps, bool quiet)
    : steps_(steps), quiet_(quiet), terminal_(::isatty(STDERR_FILENO) == 1) {}

void Progress::warn(const StepReport& report) {
  for (const std::string& warning : report.warnings) {
    if (!warned_.insert(warning).second || static_cast<int>(warned_.size()) > most_warnings) continue;
    clear_bar();
    std::fprintf(stderr, "warning: %s\n", warning.c_str());
  }
}

double Progress::fraction(const Simulation& simulation) const {
  const double span = simulation.scene().time.end - first_time_;
  double done = span > 0 ? (simulation.time() - first_time_) / span : 1;
  if (steps_ && *steps_ > 0)
    done = std::max(done, static_cast<double>(simulation.report().step - first_step_) / static_cast<double>(*steps_));
  return std::clamp(done, 0.0, 1.0);
}

std::string Progress::line(const Simulation& simulation, double seconds) const {
  const double done = fraction(simulation);
  const StepReport& report = simulation.report();
  char text[200];
  std::snprintf(text, sizeof text, "%3.0f %%  t = %.4g of %.4g s  step %ld  %d Newton  %.3g ms", 100 * done,
                simulation.time(), simulation.scene().time.end, report.step, static_cast<int>(report.newton.size()),
                report.ms.total);
  std::string line = text;
  if (done > 0 && seconds > 0.5) line += "  " + clock_text(seconds * (1 - done) / done) + " left";
  return line;
}

void Progress::clear_bar() {
  if (bar_shown_) std::fputs("\r\033[K", stderr);
  bar_shown_ = false;
}

void Progress::on_state(const Simulation& simulation) {
  warn(simulation.report());
  const Clock::time_point now = Clock::now();
  if (!begun_) {
    begun_ = true;
    start_ = last_ = now;
    first_time_ = simulation.time();
    first_step_ = simulation.report().step;
    return;
  }
  if (quiet_) return;
  const auto since = [now](Clock::time_point then) { return std::chrono::duration<double>(now - then).count(); };
  if (since(last_) < (terminal_ ? bar_interval : line_interval)) return;
  last_ = now;
  const std::string text = line(simulation, since(start_));
  if (!terminal_) {
    std::fprintf(stderr, "%s\n", text.c_str());
    return;
  }
  const int filled = static_cast<int>(std::lround(bar_width * fraction(simulation)));
  std::string bar;
  for (int i = 0; i < bar_width; ++i) bar += i < filled ? "\u2588" : "\u2591";
  std::fprintf(stderr, "\r\033[K%s %s", bar.c_str(), text.c_str());
  std::fflush(stderr);
  bar_shown_ = true;
}

void Progress::on_end(const Simulation& /*simulation*/, const RunResult& result) {
  warn(result.last_attempt);
  clear_bar();
  const auto more = static_cast<long>(warned_.size()) - most_warnings;
  if (more > 0) std::fprintf(stderr, "warning: %ld more like these; with --out DIR, summary.json lists all\n", more);
}

}  // namespace pf::app
