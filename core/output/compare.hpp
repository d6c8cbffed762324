// pushforward compare: how far two runs are apart, field by field and in time.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pf {

/// One field of both runs. Components of a vector are one field; the energies share their scale.
struct FieldDifference {
  std::string file;    ///< "stats.csv", "probes.csv", "export"
  std::string field;   ///< "kinetic_energy", "tip v", "stress"
  double largest = 0;  ///< largest |a - b|, in the field's own unit; of vectors and tensors the norm
  double rms = 0;      ///< root mean square of |a - b| over time (and particles)
  double scale = 0;    ///< largest |a| or |b| of the field; of positions the largest displacement
  double time = 0;     ///< where the largest one is [s]; NaN where the export does not say
  bool judged = true;  ///< iterations, step sizes, errors against an exact motion are shown, not judged
  /// largest / scale, 0 where the runs are equal; infinite where a number is missing on one side only.
  double relative() const;
};

struct Comparison {
  std::vector<FieldDifference> fields;
  std::vector<std::string> notes;  ///< what only one of them has, how rows were matched
  /// Largest relative difference of what is judged.
  double worst() const;
};

/// Two folders that run --out wrote. Rows are matched in time: A's against B's, interpolated linearly where B has
/// none of that time. Throws FileError where a folder has no stats.csv, InputError where it cannot be understood.
Comparison compare_runs(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace pf
