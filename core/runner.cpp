#include "core/runner.hpp"

#include <algorithm>
#include <cmath>

#include "core/live_edit.hpp"

namespace pf {

namespace {

// t_n = n step carries rounding: times this much apart, in steps, are the same.
constexpr double same_time = 1e-9;

double frame_interval(const TimeSettings& settings) {
  return settings.frame.value_or(settings.step);
}

}  // namespace

EventSchedule::EventSchedule(const Scene& scene, std::size_t applied) : applied_(applied) {
  for (std::size_t i = 0; i < scene.events.size(); ++i) entries_.push_back({i, scene.events[i]});
  std::stable_sort(entries_.begin(), entries_.end(),
                   [](const Entry& a, const Entry& b) { return a.event.time < b.event.time; });
}

void EventSchedule::apply_next(Simulation& simulation, bool strokes) {
  const Entry& entry = entries_[applied_];
  const std::string place = "/events/" + std::to_string(entry.index);
  if (!entry.event.set.empty() && !simulation.apply(edited_live(simulation.scene(), entry.event.set))) {
    std::string pointers;
    for (const Edit& edit : entry.event.set) pointers += (pointers.empty() ? "" : ", ") + edit.pointer;
    throw InputError(
        "", {{place + "/set", pointers, "settings that may change while the simulation runs; these need a reset"}});
  }
  for (std::size_t k = 0; strokes && k < entry.event.strokes.size(); ++k) {
    try {
      simulation.stroke(entry.event.strokes[k]);
    } catch (const InputError& error) {
      const Problem& problem = error.problems().front();
      throw InputError("", {{place + "/strokes/" + std::to_string(k), problem.found, problem.allowed}});
    }
  }
  ++applied_;
}

std::size_t EventSchedule::apply_due(Simulation& simulation) {
  const std::size_t before = applied_;
  while (applied_ < entries_.size() &&
         simulation.time() >= entries_[applied_].event.time - same_time * simulation.scene().time.step)
    apply_next(simulation, true);
  return applied_ - before;
}

void EventSchedule::apply_first(Simulation& simulation, std::size_t count) {
  while (applied_ < std::min(count, entries_.size())) apply_next(simulation, false);
}

bool frame_due(const TimeSettings& settings, double time, long k) {
  return time >= static_cast<double>(k) * frame_interval(settings) - same_time * settings.step;
}

long next_frame(const TimeSettings& settings, double time, long k) {
  const double passed = std::floor((time + same_time * settings.step) / frame_interval(settings));
  long next = std::max(k, static_cast<long>(passed)) + 1;
  while (frame_due(settings, time, next)) ++next;  // the quotient may have been rounded down
  return next;
}

Runner::Runner(Simulation& simulation, const RunCursor& cursor)
    : simulation_(simulation), cursor_(cursor), events_(simulation.scene(), cursor.events) {}

void Runner::show_state() {
  for (RunObserver* observer : observers_) observer->on_state(simulation_);
  const TimeSettings& settings = simulation_.scene().time;
  shown_ = frame_due(settings, simulation_.time(), cursor_.next_due);
  if (shown_) {
    for (RunObserver* observer : observers_) observer->on_frame(simulation_, cursor_.frames);
    ++cursor_.frames;
    cursor_.next_due = next_frame(settings, simulation_.time(), cursor_.next_due);
  }
  for (RunObserver* observer : observers_) observer->on_settled(simulation_, cursor_);
}

RunResult Runner::finish(RunEnd end, const StepReport& last_attempt) {
  const RunResult result{end, last_attempt, cursor_};
  if (!shown_)
    for (RunObserver* observer : observers_) observer->on_frame(simulation_, cursor_.frames);
  for (RunObserver* observer : observers_) observer->on_end(simulation_, result);
  return result;
}

RunResult Runner::run(const RunLimits& limits, const std::atomic<bool>* cancel) {
  show_state();
  auto landing = limits.landings.begin();
  const double whole = simulation_.scene().time.end;
  for (long taken = 0; !limits.steps || taken < *limits.steps; ++taken) {
    while (landing != limits.landings.end() && simulation_.time() >= *landing) ++landing;
    if (!limits.landings.empty()) simulation_.set_end(landing == limits.landings.end() ? whole : *landing);
    if (cancel != nullptr && cancel->load()) return finish(RunEnd::interrupted, simulation_.report());
    events_.apply_due(simulation_);
    cursor_.events = events_.applied();
    const StepReport& report = simulation_.step(cancel);
    if (report.status == StepStatus::finished) break;
    if (report.status == StepStatus::cancelled) return finish(RunEnd::interrupted, report);
    if (report.status == StepStatus::failed) return finish(RunEnd::failed, report);
    show_state();
  }
  return finish(RunEnd::done, simulation_.report());
}

}  // namespace pf
