// What the Advice drawer remembers: the trials under way, what they have shown, and for which settings.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/context.hpp"
#include "app/panels/runs.hpp"
#include "core/advice/advice.hpp"

namespace pf::app {

class AdviceDesk {
 public:
  explicit AdviceDesk(AppContext& context);
  ~AdviceDesk();  ///< cancels and joins
  AdviceDesk(const AdviceDesk&) = delete;
  AdviceDesk& operator=(const AdviceDesk&) = delete;

  /// Trials from the run's newest state, on a thread of their own; those under way are given up.
  void ask(AppContext& context);
  void cancel();
  /// Once a turn of the window: takes over what has come.
  void follow(AppContext& context);

  bool busy() const { return waiting_ || running_; }
  double progress() const { return progress_; }
  /// Of the last trials that came to their end; null: none did.
  const AdviceReport* report() const { return report_.get(); }
  /// Why the last ones did not; "": they did.
  const std::string& failure() const { return failure_; }

  enum class Use {
    offered,  ///< the scene is as it was when it was judged
    taken,    ///< the scene is that with this advice followed
    stale,    ///< the scene is another one
  };
  Use use_of(const AppContext& context, const Trial& trial) const;
  /// Puts the trial's settings into the scene, in one undo step.
  void take(AppContext& context, const Trial& trial) const;
  /// The settings as they were when the scene was judged, in one undo step.
  void take_back(AppContext& context, const Trial& trial) const;

  PlotView view;
  bool show_chart = false;  ///< in a narrow drawer: the chart instead of the list

 private:
  struct Outcome {
    std::shared_ptr<const AdviceReport> report;  ///< null: cancelled
    std::string failure;
  };
  void judge(const TrialStart& start, int threads);

  std::function<void()> wake_;
  bool waiting_ = false, running_ = false;
  Scene asked_for_, judged_;  ///< as edited when the trials were asked for; what `report_` is about
  std::shared_ptr<const AdviceReport> report_;
  std::string failure_;
  std::atomic<double> progress_{0};
  std::atomic<bool> cancel_{false};
  std::mutex mutex_;  ///< of what the thread leaves
  std::optional<Outcome> outcome_;
  std::jthread thread_;  // last: it uses all of the above
};

/// The desk of the context, made on the first call.
AdviceDesk& advice_of(AppContext& context);

}  // namespace pf::app
