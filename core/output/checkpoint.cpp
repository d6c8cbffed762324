#include "core/output/checkpoint.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/build_info.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"
#include "core/scene/scene_io.hpp"

namespace pf {

namespace {

using nlohmann::json;

constexpr const char* magic = "pushforward/checkpoint 1\n";

[[noreturn]] void refuse(const std::string& file, std::string found, std::string allowed) {
  throw InputError(file, {{"", std::move(found), std::move(allowed)}});
}

json to_json(const CheckpointHeader& header, const std::string& state) {
  return {{"version", header.version},
          {"commit", header.commit},
          {"identity", header.identity},
          {"scene", header.scene},
          {"time", header.time},
          {"step", header.step},
          {"number", header.number},
          {"frames", header.cursor.frames},
          {"next_due", header.cursor.next_due},
          {"events", header.cursor.events},
          {"bytes", state.size()},
          {"checksum", content_hash(state)}};
}

CheckpointHeader header_from(const json& text) {
  CheckpointHeader header;
  text.at("version").get_to(header.version);
  text.at("commit").get_to(header.commit);
  text.at("identity").get_to(header.identity);
  text.at("scene").get_to(header.scene);
  text.at("time").get_to(header.time);
  text.at("step").get_to(header.step);
  text.at("number").get_to(header.number);
  text.at("frames").get_to(header.cursor.frames);
  text.at("next_due").get_to(header.cursor.next_due);
  text.at("events").get_to(header.cursor.events);
  return header;
}

}  // namespace

std::string checkpoint_identity(const Scene& scene) {
  Scene physics = scene;
  const Scene blank;
  physics.name = blank.name;
  physics.about = blank.about;
  physics.view = blank.view;
  physics.probes = blank.probes;
  physics.time.end = blank.time.end;
  physics.time.frame = blank.time.frame;
  return scene_hash(physics);
}

void write_checkpoint(const std::filesystem::path& file, const Simulation& simulation, const CheckpointHeader& header) {
  std::ostringstream state(std::ios::binary);
  simulation.save_state(state);
  const std::string bytes = state.str();
  write_atomically(file, magic + to_json(header, bytes).dump() + '\n' + bytes);
}

Checkpoint read_checkpoint(const std::filesystem::path& file) {
  const std::string bytes = read_file(file);
  const std::string start = magic;
  if (!bytes.starts_with(start))
    refuse(file.string(), "no checkpoint", "a file that run --checkpoint-every wrote (checkpoints/NNNNNN.pfc)");
  const std::size_t end = bytes.find('\n', start.size());
  const json text =
      json::parse(bytes.begin() + static_cast<long>(start.size()),
                  end == std::string::npos ? bytes.end() : bytes.begin() + static_cast<long>(end), nullptr, false);
  const std::string damaged = "a damaged or cut-off checkpoint";
  const std::string another = "an undamaged one: the checkpoint before it";
  Checkpoint checkpoint;
  try {
    checkpoint.header = header_from(text);
    checkpoint.state = bytes.substr(end + 1);
    if (text.at("bytes") != checkpoint.state.size() || text.at("checksum") != content_hash(checkpoint.state))
      refuse(file.string(), damaged, another);
  } catch (const json::exception&) {
    refuse(file.string(), damaged, another);
  }
  if (checkpoint.header.version != build_info().version)
    refuse(file.string(), "a checkpoint of version " + checkpoint.header.version,
           "one of this program's version, " + std::string(build_info().version));
  return checkpoint;
}

void resume(Simulation& simulation, const Scene& scene, const Checkpoint& checkpoint, const std::string& file) {
  if (checkpoint.header.identity != checkpoint_identity(scene))
    refuse(file, "a checkpoint of another scene (\"" + checkpoint.header.scene + "\") or of other settings",
           "one of this very scene; only name, about, view, probes, time.end and time.frame may differ");
  EventSchedule events(scene);
  events.apply_first(simulation, checkpoint.header.cursor.events);
  std::istringstream state(checkpoint.state, std::ios::binary);
  simulation.load_state(state);
}

CheckpointWriter::CheckpointWriter(std::filesystem::path folder, const Scene& scene, double interval, double from_time,
                                   long next)
    : folder_(std::move(folder)), interval_(interval), due_(0), next_(next) {
  make_folder(folder_);
  header_.version = build_info().version;
  header_.commit = build_info().commit;
  header_.identity = checkpoint_identity(scene);
  header_.scene = scene.name;
  // The state that a run is continued from has its checkpoint already.
  if (next > 0) due_ = static_cast<long>(std::floor(from_time / interval_ + 1e-9)) + 1;
}

void CheckpointWriter::write(const Simulation& simulation, const RunCursor& cursor) {
  header_.time = simulation.time();
  header_.step = simulation.report().step;
  header_.cursor = cursor;
  header_.number = next_;
  write_checkpoint(folder_ / (file_number(next_) + ".pfc"), simulation, header_);
  last_step_ = header_.step;
  ++next_;
}

void CheckpointWriter::on_settled(const Simulation& simulation, const RunCursor& cursor) {
  const double tolerance = 1e-9 * simulation.scene().time.step;
  if (simulation.time() < static_cast<double>(due_) * interval_ - tolerance) return;
  write(simulation, cursor);
  due_ = std::max(due_, static_cast<long>(std::floor((simulation.time() + tolerance) / interval_))) + 1;
}

void CheckpointWriter::on_end(const Simulation& simulation, const RunResult& result) {
  if (simulation.report().step != last_step_) write(simulation, result.cursor);
}

}  // namespace pf
