// Runs a study, one setting after the other: for the command line all at once, for the app step by step. What is
// finished is on disk; a study that was cut off goes on where it was.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/studies/measure.hpp"
#include "core/studies/row.hpp"
#include "core/studies/study.hpp"

namespace pf {

struct StudyOptions {
  std::filesystem::path folder;  ///< of results.csv and study.json; "" writes nothing
  std::filesystem::path cache;   ///< of fine runs; "" keeps none
  bool fresh = false;            ///< drop what an earlier study left in the folder
};

/// All members may be called from any thread; `advance` from several at once runs several settings at once.
class StudyDriver {
 public:
  /// Takes over the rows that the folder holds of this very study. Throws InputError where it holds another study, or
  /// this one by another version of the program; FileError.
  StudyDriver(Study study, StudyOptions options);

  const Study& study() const { return study_; }
  std::size_t size() const { return order_.size(); }
  std::size_t finished() const;
  /// So many of them were there already.
  std::size_t resumed() const { return resumed_; }
  /// The finished rows, by setting.
  std::vector<StudyRow> rows() const;

  /// Makes the fine run, where the study asks for one; `progress` is told its share done. False when cancelled.
  bool prepare(const std::atomic<bool>* cancel, const std::function<void(double)>& progress = {});
  /// Runs the next setting, keeps its row and returns it; nothing when none is left or `cancel` was set. Call
  /// prepare() before.
  std::optional<StudyRow> advance(const std::atomic<bool>* cancel);
  /// Runs all that is left on `jobs` threads; timed studies run one at a time whatever `jobs` says. `on_row` is told
  /// each row, one at a time. False when cancelled.
  bool run(int jobs, const std::atomic<bool>* cancel, const std::function<void(const StudyRow&)>& on_row = {});

  /// Time left [s], from what the finished ones took; NaN before the first.
  double seconds_left() const;

 private:
  void resume();
  void write() const;
  double predicted(std::size_t point) const;

  Study study_;
  StudyOptions options_;
  std::vector<std::size_t> order_;
  std::vector<double> predicted_;  ///< cost of each setting in a unit of its own
  std::unique_ptr<Reference> reference_;
  std::size_t resumed_ = 0;

  mutable std::mutex mutex_;
  std::size_t next_ = 0;
  std::vector<std::optional<StudyRow>> rows_;  ///< by setting
  double predicted_done_ = 0, seconds_done_ = 0;
  int running_ = 0;
};

}  // namespace pf
