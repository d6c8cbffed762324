#include "core/studies/driver.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <thread>

#include "core/files.hpp"
#include "core/params/problem.hpp"
#include "core/scene/scene_io.hpp"
#include "core/studies/results.hpp"

namespace pf {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

}  // namespace

StudyDriver::StudyDriver(Study study, StudyOptions options)
    : study_(std::move(study)), options_(std::move(options)), order_(study_order(study_)), rows_(order_.size()) {
  for (std::size_t k = 0; k < order_.size(); ++k) predicted_.push_back(predicted(k));
  if (options_.folder.empty()) return;
  make_folder(options_.folder);
  resume();
  write();
}

/// Steps times cells: good enough to tell how much is left.
double StudyDriver::predicted(std::size_t point) const {
  try {
    const Scene scene = study_scene(study_, study_point(study_, point));
    double particles = std::pow(scene.grid.spacing, -scene.dimension);
    for (const Body& body : scene.bodies)
      particles *= std::pow(body.particles_per_axis,
                            static_cast<double>(scene.dimension) / static_cast<double>(scene.bodies.size()));
    return std::ceil(scene.time.end / scene.time.step) * particles;
  } catch (const InputError&) {
    return 0;
  }
}

void StudyDriver::resume() {
  const fs::path results = options_.folder / "results.csv", about = options_.folder / "study.json";
  std::error_code ignored;
  if (!fs::exists(about, ignored) || !fs::exists(results, ignored)) return;
  if (options_.fresh) return;
  const auto text = nlohmann::json::parse(read_file(about), nullptr, false);
  const auto is = [&text](const char* key, const std::string& value) {
    return text.is_object() && text.contains(key) && text[key] == value;
  };
  const bool same_study = is("identity", study_identity(study_)), same_program = is("program", program_identity());
  if (!same_study || !same_program)
    throw InputError("", {{"--out",
                           options_.folder.string() + " with results of " +
                               (same_study ? "this study by another build of the program" : "another study"),
                           "another folder, or --fresh to replace them", 0}});
  for (StudyRow& row :
       read_results(read_file(results), results.string(), varied_columns(study_), varied_texts(study_))) {
    if (!rows_[row.point]) ++resumed_;
    rows_[row.point] = std::move(row);
  }
}

std::size_t StudyDriver::finished() const {
  const std::lock_guard lock(mutex_);
  return static_cast<std::size_t>(
      std::count_if(rows_.begin(), rows_.end(), [](const auto& r) { return r.has_value(); }));
}

std::vector<StudyRow> StudyDriver::rows() const {
  const std::lock_guard lock(mutex_);
  std::vector<StudyRow> rows;
  for (const auto& row : rows_)
    if (row) rows.push_back(*row);
  return rows;
}

void StudyDriver::write() const {
  if (options_.folder.empty()) return;
  std::vector<StudyRow> rows;
  for (const auto& row : rows_)
    if (row) rows.push_back(*row);
  write_atomically(options_.folder / "results.csv", results_csv(study_, rows));
  write_atomically(options_.folder / "study.json", study_document(study_, rows.size()).dump(2) + '\n');
}

bool StudyDriver::prepare(const std::atomic<bool>* cancel, const std::function<void(double)>& progress) {
  if (reference_ || study_.reference != ReferenceKind::run || finished() == size()) return true;
  const Scene scene = reference_scene(study_);
  std::optional<ReferenceRun> run =
      options_.cache.empty()
          ? run_reference(scene, study_.samples, study_.threads, cancel, progress)
          : cached_reference(scene, study_.samples, study_.threads, options_.cache, cancel, progress);
  if (!run) return false;
  reference_ = make_run_reference(std::make_shared<const ReferenceRun>(std::move(*run)));
  return true;
}

std::optional<StudyRow> StudyDriver::advance(const std::atomic<bool>* cancel) {
  std::size_t point = 0;
  {
    const std::lock_guard lock(mutex_);
    while (next_ < order_.size() && rows_[order_[next_]]) ++next_;
    if (next_ == order_.size() || (cancel != nullptr && cancel->load())) return std::nullopt;
    point = order_[next_++];
    ++running_;
  }
  const Clock::time_point begin = Clock::now();
  bool cancelled = false;
  StudyRow row;
  try {
    const Scene scene = study_scene(study_, study_point(study_, point));
    // Each run's own scene says where the exact motion is: its dt, dx and constants may be varied.
    const std::unique_ptr<Reference> exact =
        study_.reference == ReferenceKind::exact ? make_exact_reference(scene) : nullptr;
    row = measure_run(scene, exact ? exact.get() : reference_.get(),
                      {.samples = study_.samples,
                       .threads = study_.threads,
                       .repeat = study_.repeat,
                       .timeout_s = study_.timeout_s,
                       .thresholds = study_.thresholds},
                      cancel, cancelled);
  } catch (const InputError& error) {
    row.status = RowStatus::failed;
    row.behaviour = RunClass::failed;
    row.reason = "these settings do not go together: " + to_string(error.problems().front());
  }
  const std::lock_guard lock(mutex_);
  --running_;
  if (cancelled) return std::nullopt;
  row.point = point;
  seconds_done_ += std::chrono::duration<double>(Clock::now() - begin).count();
  predicted_done_ += predicted_[point];
  rows_[point] = row;
  write();
  return row;
}

bool StudyDriver::run(int jobs, const std::atomic<bool>* cancel, const std::function<void(const StudyRow&)>& on_row) {
  std::exception_ptr trouble;
  std::mutex telling;
  const auto work = [&] {
    try {
      while (const std::optional<StudyRow> row = advance(cancel)) {
        const std::lock_guard lock(telling);
        if (trouble) return;
        if (on_row) on_row(*row);
      }
    } catch (...) {  // a disk that is full: handed on to the caller
      const std::lock_guard lock(telling);
      trouble = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (int k = 1; k < (study_.cost == "wall" ? 1 : jobs); ++k) helpers.emplace_back(work);
    work();
  }
  if (trouble) std::rethrow_exception(trouble);
  return finished() == size();
}

double StudyDriver::seconds_left() const {
  const std::lock_guard lock(mutex_);
  double left = 0;
  for (std::size_t k = 0; k < rows_.size(); ++k) left += rows_[k] ? 0 : predicted_[k];
  if (left == 0) return 0;
  return predicted_done_ > 0 ? left * seconds_done_ / predicted_done_ / std::max(1, running_) : not_measured;
}

}  // namespace pf
