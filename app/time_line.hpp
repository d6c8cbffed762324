// The time line under the view: what has been simulated, where one is, what was edited and where there was trouble.
#pragma once

#include <optional>
#include <vector>

#include "app/context.hpp"
#include "app/layout.hpp"
#include "core/diagnostics/bad_steps.hpp"

namespace pf::app {

class TimeLine {
 public:
  /// Looks at the steps that are new.
  void follow(const AppContext& context);
  /// Fills `place`. Press and drag go to the step under the mouse.
  void draw(AppContext& context, const Rect& place);

  const std::vector<BadStep>& bad_steps() const { return bad_; }
  /// The next one after the step shown, from the beginning again where there is none; a run that failed ends with one.
  std::optional<BadStep> next_bad(const AppContext& context) const;
  bool any_bad(const AppContext& context) const;
  /// The step that is shown, or that is on its way.
  static long wanted_step(const SessionStatus& status) { return status.target >= 0 ? status.target : status.step; }

 private:
  void draw_marks(const AppContext& context, const Rect& place, double end);
  void tell(const AppContext& context, double time) const;
  std::vector<BadStep> all_bad(const AppContext& context) const;

  std::vector<BadStep> bad_;
  std::vector<double> edits_;  ///< when something was edited [s]
  std::uint64_t run_ = 0, branches_ = 0, edit_ = 0;
  std::size_t seen_ = 0;  ///< reports judged
  long sent_ = -1;        ///< the step that a drag has asked for
};

}  // namespace pf::app
