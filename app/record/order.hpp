// What is recorded of a run while it runs, and when.
#pragma once

#include <filesystem>
#include <string>

namespace pf {
struct ExportFormat;  // core/output/export.hpp
}

namespace pf::app {

/// When frames are due: every so many steps, or (`seconds` > 0) every so much simulated time.
struct FrameSchedule {
  long steps = 1;      ///< at least 1
  double seconds = 0;  ///< [s]
};

/// Tells which states of a run are due. The one that it begins with is the first; each is asked about once.
class FrameClock {
 public:
  FrameClock(const FrameSchedule& schedule, long step, double time) : every_(schedule), step_(step), time_(time) {}
  /// The state after `step` at `time`, reached by a step of `dt` [s], is due. As INTERFACE has it: a frame is due at
  /// the first step with t >= k frame - 1e-9 dt, counted from the state that the record begins with; steps are never
  /// shortened for it. What was asked about before, or lies before it, is not.
  bool due(long step, double time, double dt);

 private:
  FrameSchedule every_;
  long step_, newest_ = -1;
  double time_;
  long frame_ = 0;  ///< the next one's number
};

struct RecordOrder {
  FrameSchedule every;
  const ExportFormat* format = nullptr;  ///< files of this kind are written; null: pictures are taken by the window
  std::filesystem::path folder;          ///< of those files
};

struct RecordProgress {
  bool on = false;      ///< the run is being recorded
  long frames = 0;      ///< that were due until now
  std::string trouble;  ///< why it ended before its time; the run itself goes on
};

}  // namespace pf::app
