#include "app/advice/desk.hpp"

#include <exception>
#include <utility>

#include "app/widgets/setting_help.hpp"
#include "core/params/problem.hpp"
#include "core/scene/scene_io.hpp"

namespace pf::app {

namespace {

/// Two scenes that run alike: what they are called and how they are looked at does not count.
bool run_alike(Scene a, const Scene& b) {
  a.name = b.name;
  a.about = b.about;
  a.view = b.view;
  a.probes = b.probes;
  return a == b;
}

}  // namespace

AdviceDesk& advice_of(AppContext& context) {
  if (!context.advice) context.advice = std::make_shared<AdviceDesk>(context);
  return *context.advice;
}

AdviceDesk::AdviceDesk(AppContext& context) : wake_(context.wake) {}

AdviceDesk::~AdviceDesk() {
  cancel_ = true;
}

void AdviceDesk::ask(AppContext& context) {
  cancel();
  context.session.asked_state();  // one that was asked for before
  context.session.ask_state();
  asked_for_ = context.scene;
  waiting_ = true;
  progress_ = 0;
  failure_.clear();
}

void AdviceDesk::cancel() {
  waiting_ = false;
  if (!running_) return;
  cancel_ = true;
  thread_ = {};  // joins: a trial's step ends within an iteration of its solver
  running_ = false;
  const std::lock_guard lock(mutex_);
  outcome_.reset();
}

void AdviceDesk::judge(const TrialStart& start, int threads) {
  Outcome outcome;
  try {
    if (auto report = advise(start, {.threads = threads}, &cancel_, [this](double share) {
          progress_ = share;
          if (wake_) wake_();
        }))
      outcome.report = std::make_shared<const AdviceReport>(*std::move(report));
  } catch (const InputError& error) {
    outcome.failure = problem_text(error.problems());
  } catch (const std::exception& error) {
    outcome.failure = error.what();
  }
  {
    const std::lock_guard lock(mutex_);
    outcome_ = std::move(outcome);
  }
  if (wake_) wake_();
}

void AdviceDesk::follow(AppContext& context) {
  if (waiting_) {
    if (std::optional<TrialStart> start = context.session.asked_state()) {
      waiting_ = false;
      running_ = true;
      cancel_ = false;
      // The live view keeps a core while it runs; threads never change a result.
      const int threads = context.status.state == RunState::running ? 1 : context.threads;
      if (wake_) wake_();
      thread_ = std::jthread([this, threads, from = *std::move(start)] { judge(from, threads); });
    } else if (context.status.state == RunState::failed) {
      waiting_ = false;
      failure_ = "The run has failed: there is no state to try things from.";
    }
  }
  if (!running_) return;
  std::optional<Outcome> outcome;
  {
    const std::lock_guard lock(mutex_);
    outcome.swap(outcome_);
  }
  if (!outcome) return;
  thread_ = {};
  running_ = false;
  failure_ = outcome->failure;
  if (wake_) wake_();
  if (!outcome->report) return;
  report_ = outcome->report;
  judged_ = asked_for_;
  view = {};
}

AdviceDesk::Use AdviceDesk::use_of(const AppContext& context, const Trial& trial) const {
  if (run_alike(context.scene, judged_)) return Use::offered;
  try {
    if (run_alike(context.scene, edited(judged_, trial.edits))) return Use::taken;
  } catch (const InputError&) {
    return Use::stale;
  }
  return Use::stale;
}

void AdviceDesk::take(AppContext& context, const Trial& trial) const {
  if (context.change(trial.edits)) context.notify(trial.sentence + ". Ctrl+Z takes it back.");
}

void AdviceDesk::take_back(AppContext& context, const Trial& trial) const {
  context.change(inverse(judged_, trial.edits));
}

}  // namespace pf::app
