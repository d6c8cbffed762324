// run --export: particles, and with vtk the active grid, one file a frame.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/output/particle_table.hpp"
#include "core/runner.hpp"

namespace pf {

/// A frame that was exported, and when it was.
struct FrameTime {
  long number = 0;
  double time = 0;  ///< [s]
};

/// One format of --export. To add one: a file with its writer and a line in export.cpp's table.
struct ExportFormat {
  std::string_view name;       ///< as --export takes it
  std::string_view extension;  ///< of the particles' file
  std::string_view about;
  std::string (*particles)(const ParticleTable& table, double time);
  std::string (*grid)(const GridTable& table, double time);  ///< nullptr where the format has no grid
  std::string_view grid_extension;
  /// A file that lists all frames, rewritten with each; nullptr where the format has none.
  std::string (*index)(std::span<const FrameTime> frames);
  std::string_view index_name;
};

std::span<const ExportFormat> export_formats();
/// nullptr when there is no such format.
const ExportFormat* find_export_format(std::string_view name);

/// Writes FOLDER/particles_NNNNNN.EXT (and grid_NNNNNN.vtu, particles.pvd) at each frame, each file whole or not at
/// all.
class Exporter : public RunObserver {
 public:
  /// `earlier`: frames that are there already (a continued run).
  Exporter(const ExportFormat& format, std::filesystem::path folder, std::vector<FrameTime> earlier = {});
  void on_frame(const Simulation& simulation, long number) override;

 private:
  const ExportFormat& format_;
  std::filesystem::path folder_;
  std::vector<FrameTime> frames_;
};

/// The file names in FOLDER/export that belong to frame `number`: used by the index too.
std::string particles_file(long number, std::string_view extension);

// The formats' writers: vtk.cpp, ply.cpp, csv.cpp.
std::string vtk_particles(const ParticleTable& table, double time);
std::string vtk_grid(const GridTable& table, double time);
std::string vtk_index(std::span<const FrameTime> frames);
std::string ply_particles(const ParticleTable& table, double time);
std::string csv_particles(const ParticleTable& table, double time);

}  // namespace pf
