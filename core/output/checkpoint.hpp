// checkpoints/NNNNNN.pfc: everything that is needed to go on from a state as if the run had never stopped.
#pragma once

#include <filesystem>
#include <string>

#include "core/runner.hpp"

namespace pf {

/// First lines of a checkpoint, in front of Simulation::save_state's bytes.
struct CheckpointHeader {
  std::string version;  ///< of the program that wrote it
  std::string commit;
  std::string identity;  ///< checkpoint_identity of the scene
  std::string scene;     ///< its name, for messages
  double time = 0;       ///< [s]
  long step = 0;
  RunCursor cursor;
  long number = 0;  ///< of the file
};

/// Hash of everything in a scene that the state depends on: not its name, text, view, end, frame interval or probes, so
/// that a run may be continued for longer than was planned.
std::string checkpoint_identity(const Scene& scene);

/// The scene as it stands in the file: events that were applied since do not change its identity.
void write_checkpoint(const std::filesystem::path& file, const Simulation& simulation, const CheckpointHeader& header);

/// A checkpoint read and checked: its state is whole (a checksum says so).
struct Checkpoint {
  CheckpointHeader header;
  std::string state;  ///< for Simulation::load_state
};
/// Throws FileError where the file cannot be read, InputError where it is no checkpoint, damaged, or of another
/// version.
Checkpoint read_checkpoint(const std::filesystem::path& file);
/// Brings `simulation`, just made from `scene`, to the checkpoint's state; events of the scene that were applied by
/// then are applied. Throws InputError where the checkpoint belongs to another scene.
void resume(Simulation& simulation, const Scene& scene, const Checkpoint& checkpoint, const std::string& file);

/// A checkpoint at the first state at or after every multiple of `interval`, and at the end whatever it was.
class CheckpointWriter : public RunObserver {
 public:
  /// `interval` > 0 [s of simulated time]; numbers go on from `next`.
  CheckpointWriter(std::filesystem::path folder, const Scene& scene, double interval, double from_time, long next = 0);
  void on_settled(const Simulation& simulation, const RunCursor& cursor) override;
  void on_end(const Simulation& simulation, const RunResult& result) override;

 private:
  void write(const Simulation& simulation, const RunCursor& cursor);

  std::filesystem::path folder_;
  CheckpointHeader header_;
  double interval_;
  long due_;  ///< the next checkpoint is due at due_ * interval_
  long next_;
  long last_step_ = -1;
};

}  // namespace pf
