// The folder that run --out fills: what is ours in it, what stays when a run is repeated or continued.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/output/checkpoint.hpp"
#include "core/output/export.hpp"

namespace pf {

struct RunFolder {
  std::filesystem::path root;
  std::filesystem::path stats() const { return root / "stats.csv"; }
  std::filesystem::path energy() const { return root / "energy.csv"; }
  std::filesystem::path probes() const { return root / "probes.csv"; }
  std::filesystem::path summary() const { return root / "summary.json"; }
  std::filesystem::path images() const { return root / "images"; }
  std::filesystem::path exports() const { return root / "export"; }
  std::filesystem::path checkpoints() const { return root / "checkpoints"; }
};

/// What of an earlier run was left in place.
struct Kept {
  std::optional<long> step;       ///< rows up to this step are in stats.csv (and probes.csv)
  std::vector<FrameTime> frames;  ///< that were due up to the checkpoint
};

/// Makes the folder. Removes what an earlier run of ours left in it, known by its stats.csv; anything else stays. With
/// `resumed`, whatever belongs to the states up to the checkpoint stays too, if the folder holds that very run.
/// Throws FileError.
Kept prepare_run_folder(const RunFolder& folder, const Scene& scene, const CheckpointHeader* resumed = nullptr);

}  // namespace pf
