// Runs a study on threads of its own. The window sends commands and reads results; neither waits for the other.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/params/problem.hpp"
#include "core/studies/row.hpp"
#include "core/studies/study.hpp"

namespace pf {
class StudyDriver;
}

namespace pf::app {

/// A study file as it stands, and where its scene is looked for.
struct StudyFile {
  std::string text;
  std::string source;            ///< for messages and titles
  std::filesystem::path folder;  ///< beside which its scene lies
};

enum class StudyStage {
  none,       ///< nothing was opened
  reading,    ///< a study file is read, its earlier results too
  ready,      ///< nothing runs; what is not finished can be begun or gone on with
  reference,  ///< the fine run
  running,
  finished,  ///< every setting has its row
  failed,    ///< could not be read, or not be gone on with
};

struct StudyStatus {
  StudyStage stage = StudyStage::none;
  std::size_t size = 0, finished = 0;  ///< settings
  double seconds_left = 0;             ///< NaN while nothing is known
  double reference_share = 0;          ///< done of the fine run
  std::vector<Problem> problems;       ///< why it failed
  bool active() const {
    return stage == StudyStage::reading || stage == StudyStage::reference || stage == StudyStage::running;
  }
};

/// What there is to show of a study: never changed once handed out.
struct StudyResults {
  std::shared_ptr<const Study> study;
  std::string text;              ///< the study file, its scene inside
  std::filesystem::path folder;  ///< where the results are kept
  std::vector<StudyRow> rows;
  std::uint64_t version = 0;  ///< another number, other contents
};

/// How it comes by a machine that does nothing else while runs are timed. Called on the runner's thread.
struct StudyHooks {
  std::function<void()> wake;          ///< something is new
  std::function<void(bool)> hold;      ///< ask the live view to stand still, or to go on
  std::function<bool()> stands_still;  ///< it does
};

/// Thread-safe towards one UI thread; every call returns at once.
class StudyRunner {
 public:
  /// `root`: below it each study gets a folder of results. `cache`: of fine runs, "" keeps none.
  StudyRunner(std::filesystem::path root, std::filesystem::path cache, StudyHooks hooks);
  ~StudyRunner();  ///< cancels and joins; finished rows are on disk
  StudyRunner(const StudyRunner&) = delete;
  StudyRunner& operator=(const StudyRunner&) = delete;

  /// Cancels what runs, reads the study and shows what earlier runs of it have left; begins it where `begin`.
  void open(StudyFile file, bool begin);
  /// Begins, or goes on with, the study that is open; `fresh`: drops its earlier results.
  void begin(bool fresh = false);
  /// Stops at once. Finished rows stay, the one under way is lost.
  void cancel();

  StudyStatus status() const;
  /// Null before the first study was read.
  std::shared_ptr<const StudyResults> results() const;

 private:
  struct Command {
    std::optional<StudyFile> open;
    bool begin = false, fresh = false;
  };
  void loop();
  void guarded(const std::function<void()>& work);
  void send(Command command);
  void read(const StudyFile& file);
  void look_for_earlier_rows();
  void run(bool fresh);
  bool wait_for_stillness();
  void run_rows(StudyDriver& driver);
  void publish(std::vector<StudyRow> rows);
  void follow(const StudyDriver& driver, bool now);
  void set_stage(StudyStage stage);
  void fail(std::vector<Problem> problems);
  void wake() const;

  const std::filesystem::path root_, cache_;
  const StudyHooks hooks_;

  mutable std::mutex mutex_;  ///< held for copies only
  std::condition_variable came_;
  std::optional<Command> next_;
  StudyStatus status_;
  std::shared_ptr<const StudyResults> results_;
  std::uint64_t version_ = 0;
  bool quitting_ = false;
  std::atomic<bool> cancel_{false};

  // The thread's own.
  std::shared_ptr<const Study> study_;
  std::string text_;
  std::filesystem::path folder_;
  std::chrono::steady_clock::time_point published_{};
  std::jthread thread_;  // last: it uses all of the above
};

}  // namespace pf::app
