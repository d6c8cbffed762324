#include "core/output/run_folder.hpp"

#include <cstdlib>
#include <sstream>
#include <system_error>

#include "core/files.hpp"
#include "core/output/stats.hpp"

namespace pf {

namespace {

namespace fs = std::filesystem;

// The number in PREFIXnnnnnn.EXTENSION, or -1 where the name is another.
long numbered(const std::string& name, const std::string& prefix, const std::string& extension) {
  const std::size_t digits = name.size() - std::min(name.size(), prefix.size() + extension.size());
  if (digits < 6 || !name.starts_with(prefix) || !name.ends_with(extension)) return -1;
  const std::string number = name.substr(prefix.size(), digits);
  if (number.find_first_not_of("0123456789") != std::string::npos) return -1;
  return std::strtol(number.c_str(), nullptr, 10);
}

// Removes PREFIXnnnnnn.EXTENSION with a number of `from` or more.
void remove_numbered(const fs::path& folder, const std::string& prefix, const std::string& extension, long from) {
  std::error_code error;
  std::vector<fs::path> ours;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (numbered(entry.path().filename().string(), prefix, extension) >= from) ours.push_back(entry.path());
  for (const fs::path& file : ours) fs::remove(file, error);
}

bool has_our_stats(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return false;
  return read_file(file).starts_with("step,time,dt,newton_iterations,");
}

// The frames before number `count`, as the frame rule gives them for the steps in stats.csv.
std::vector<FrameTime> earlier_frames(const fs::path& stats, const TimeSettings& settings, long count) {
  std::vector<FrameTime> frames;
  std::istringstream text(read_file(stats));
  std::string line;
  std::getline(text, line);
  long due = 0;
  while (static_cast<long>(frames.size()) < count && std::getline(text, line)) {
    const double time = std::strtod(line.c_str() + line.find(',') + 1, nullptr);
    if (!frame_due(settings, time, due)) continue;
    frames.push_back({static_cast<long>(frames.size()), time});
    due = next_frame(settings, time, due);
  }
  return frames;
}

}  // namespace

Kept prepare_run_folder(const RunFolder& folder, const Scene& scene, const CheckpointHeader* resumed) {
  make_folder(folder.root);
  Kept kept;
  if (!has_our_stats(folder.stats())) return kept;
  const std::string header = stats_header(stats_columns(scene));
  if (resumed != nullptr && keep_stats_until(folder.stats(), header, resumed->step, resumed->time)) {
    kept.step = resumed->step;
    kept.frames = earlier_frames(folder.stats(), scene.time, resumed->cursor.frames);
    keep_probes_until(folder.probes(), probes_header(scene.dimension), resumed->time);
  }
  const long frames = kept.step ? resumed->cursor.frames : 0;
  remove_numbered(folder.images(), "", ".png", frames);
  for (const char* extension : {".vtp", ".ply", ".csv"})
    remove_numbered(folder.exports(), "particles_", extension, frames);
  remove_numbered(folder.exports(), "grid_", ".vtu", frames);
  remove_numbered(folder.checkpoints(), "", ".pfc", kept.step ? resumed->number + 1 : 0);
  std::error_code ignored;
  fs::remove(folder.summary(), ignored);
  if (kept.step) return kept;
  fs::remove(folder.exports() / "particles.pvd", ignored);
  fs::remove(folder.probes(), ignored);
  fs::remove(folder.energy(), ignored);
  return kept;
}

}  // namespace pf
