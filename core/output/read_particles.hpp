// Exported particles read back, whichever of our formats they were written in.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pf {

/// One quantity of every particle, its components interleaved.
struct ReadField {
  std::string name;  ///< "position", "velocity", "F", "stress", ...
  std::size_t components = 1;
  std::vector<double> values;
};

struct ReadParticles {
  double time = 0;  ///< [s]; NaN where the format does not say (csv)
  std::vector<ReadField> fields;
  const ReadField* find(const std::string& name) const;
};

/// A file that run --export wrote (.vtp, .ply, .csv). Throws FileError, or InputError where it is not one of ours.
ReadParticles read_particles(const std::filesystem::path& file);

}  // namespace pf
