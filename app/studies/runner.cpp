#include "app/studies/runner.hpp"

#include <chrono>
#include <utility>

#include "app/studies/library.hpp"
#include "core/files.hpp"
#include "core/studies/driver.hpp"
#include "core/studies/study_io.hpp"

namespace pf::app {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

/// Every row is shown at once, unless copying them for the window would cost more than running.
constexpr std::size_t many_rows = 2000;
constexpr std::chrono::milliseconds between_looks{50};

/// Untimed runs leave a processor to the live view.
int jobs_beside_the_view() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
}

}  // namespace

StudyRunner::StudyRunner(fs::path root, fs::path cache, StudyHooks hooks)
    : root_(std::move(root)), cache_(std::move(cache)), hooks_(std::move(hooks)) {
  thread_ = std::jthread([this] { loop(); });
}

StudyRunner::~StudyRunner() {
  {
    const std::lock_guard lock(mutex_);
    quitting_ = true;
    cancel_ = true;
  }
  came_.notify_one();
  thread_.join();
}

void StudyRunner::send(Command command) {
  {
    const std::lock_guard lock(mutex_);
    if (command.open) {
      cancel_ = true;
      status_ = {};
      status_.stage = StudyStage::reading;
      next_ = std::move(command);
    } else if (next_) {  // an opened study that is still waiting
      next_->begin |= command.begin;
      next_->fresh |= command.fresh;
    } else {
      next_ = std::move(command);
    }
  }
  came_.notify_one();
}

void StudyRunner::open(StudyFile file, bool begin) {
  send({std::move(file), begin, false});
}
void StudyRunner::begin(bool fresh) {
  send({std::nullopt, true, fresh});
}

void StudyRunner::cancel() {
  const std::lock_guard lock(mutex_);
  cancel_ = true;
  if (next_) next_->begin = false;
}

StudyStatus StudyRunner::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

std::shared_ptr<const StudyResults> StudyRunner::results() const {
  const std::lock_guard lock(mutex_);
  return results_;
}

void StudyRunner::loop() {
  while (true) {
    Command command;
    {
      std::unique_lock lock(mutex_);
      came_.wait(lock, [this] { return quitting_ || next_; });
      if (quitting_) return;
      command = std::move(*next_);
      next_.reset();
      cancel_ = false;  // whoever asked for it has sent this command since, or is content with what was stopped
    }
    guarded([&] {
      if (command.open) read(*command.open);
      if (command.begin && study_) run(command.fresh);
    });
  }
}

void StudyRunner::guarded(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    fail(error.problems());
  } catch (const std::exception& error) {
    fail({{"", error.what(), "", 0}});
  }
}

void StudyRunner::read(const StudyFile& file) {
  study_.reset();
  {
    const std::lock_guard lock(mutex_);
    results_.reset();
  }
  set_stage(StudyStage::reading);
  // With the scene inside, so that results can be opened again whatever becomes of the scene's file.
  text_ = self_contained(file.text, parse_study(file.text, file.source, file.folder));
  study_ = std::make_shared<const Study>(parse_study(text_, file.source, file.folder));
  folder_ = root_.empty() ? fs::path() : results_folder(root_, *study_);
  look_for_earlier_rows();
}

void StudyRunner::look_for_earlier_rows() {
  std::vector<StudyRow> rows;
  std::error_code ignored;
  if (!folder_.empty() && fs::exists(folder_ / "results.csv", ignored))
    rows = StudyDriver(*study_, {.folder = folder_, .cache = cache_, .fresh = false}).rows();
  const bool complete = rows.size() == study_size(*study_);
  {
    const std::lock_guard lock(mutex_);
    status_.size = study_size(*study_);
    status_.finished = rows.size();
  }
  publish(std::move(rows));
  set_stage(complete ? StudyStage::finished : StudyStage::ready);
}

void StudyRunner::run(bool fresh) {
  if (!folder_.empty()) {
    make_folder(folder_);
    write_atomically(folder_ / definition_name, text_);
  }
  StudyDriver driver(*study_, {.folder = folder_, .cache = cache_, .fresh = fresh});
  follow(driver, true);
  bool prepared = true;
  if (study_->reference == ReferenceKind::run && driver.finished() < driver.size()) {
    set_stage(StudyStage::reference);
    double told = 0;
    prepared = driver.prepare(&cancel_, [&](double share) {
      if (share < told + 0.02) return;
      told = share;
      {
        const std::lock_guard lock(mutex_);
        status_.reference_share = share;
      }
      wake();
    });
  }
  if (prepared) {
    set_stage(StudyStage::running);
    run_rows(driver);
  }
  follow(driver, true);
  set_stage(driver.finished() == driver.size() ? StudyStage::finished : StudyStage::ready);
}

/// False when cancelled.
bool StudyRunner::wait_for_stillness() {
  while (!cancel_ && hooks_.stands_still && !hooks_.stands_still())
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  return !cancel_;
}

void StudyRunner::run_rows(StudyDriver& driver) {
  const bool timed = study_->cost == "wall";
  if (timed && hooks_.hold) hooks_.hold(true);
  const auto let_go = [&] {
    if (timed && hooks_.hold) hooks_.hold(false);
  };
  try {
    if (!timed || wait_for_stillness())
      driver.run(jobs_beside_the_view(), &cancel_, [&](const StudyRow&) { follow(driver, false); });
  } catch (...) {
    let_go();
    throw;
  }
  let_go();
}

void StudyRunner::follow(const StudyDriver& driver, bool now) {
  if (!now && driver.size() > many_rows && Clock::now() < published_ + between_looks) return;
  std::vector<StudyRow> rows = driver.rows();
  const double left = driver.seconds_left();
  {
    const std::lock_guard lock(mutex_);
    status_.size = driver.size();
    status_.finished = rows.size();
    status_.seconds_left = left;
  }
  publish(std::move(rows));
}

void StudyRunner::publish(std::vector<StudyRow> rows) {
  auto fresh = std::make_shared<StudyResults>();
  fresh->study = study_;
  fresh->text = text_;
  fresh->folder = folder_;
  fresh->rows = std::move(rows);
  {
    const std::lock_guard lock(mutex_);
    fresh->version = ++version_;
    results_ = std::move(fresh);
  }
  published_ = Clock::now();
  wake();
}

void StudyRunner::set_stage(StudyStage stage) {
  {
    const std::lock_guard lock(mutex_);
    if (next_ && next_->open) return;  // another study is on its way: its "reading" stands
    status_.stage = stage;
  }
  wake();
}

void StudyRunner::fail(std::vector<Problem> problems) {
  {
    const std::lock_guard lock(mutex_);
    if (next_ && next_->open) return;
    status_.stage = StudyStage::failed;
    status_.problems = std::move(problems);
  }
  wake();
}

void StudyRunner::wake() const {
  if (hooks_.wake) hooks_.wake();
}

}  // namespace pf::app
