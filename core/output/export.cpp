#include "core/output/export.hpp"

#include "core/files.hpp"

namespace pf {

namespace {

constexpr ExportFormat table[] = {
    {"vtk", "vtp", "VTK XML for ParaView: particles, the active grid, and a .pvd index", vtk_particles, vtk_grid, "vtu",
     vtk_index, "particles.pvd"},
    {"ply", "ply", "binary PLY points for Blender, MeshLab, Houdini", ply_particles, nullptr, "", nullptr, ""},
    {"csv", "csv", "comma-separated text, one row a particle", csv_particles, nullptr, "", nullptr, ""},
};

}  // namespace

std::span<const ExportFormat> export_formats() {
  return table;
}

const ExportFormat* find_export_format(std::string_view name) {
  for (const ExportFormat& format : table)
    if (format.name == name) return &format;
  return nullptr;
}

std::string particles_file(long number, std::string_view extension) {
  return "particles_" + file_number(number) + "." + std::string(extension);
}

Exporter::Exporter(const ExportFormat& format, std::filesystem::path folder, std::vector<FrameTime> earlier)
    : format_(format), folder_(std::move(folder)), frames_(std::move(earlier)) {
  make_folder(folder_);
}

void Exporter::on_frame(const Simulation& simulation, long number) {
  const double time = simulation.time();
  const ParticleTable particles = particle_table(simulation.particles(), simulation.scene().dimension);
  write_atomically(folder_ / particles_file(number, format_.extension), format_.particles(particles, time));
  if (format_.grid != nullptr) {
    Snapshot snapshot;
    simulation.capture({.fields = 0, .grid = true, .velocities = false}, snapshot);
    write_atomically(folder_ / ("grid_" + file_number(number) + "." + std::string(format_.grid_extension)),
                     format_.grid(grid_table(snapshot), time));
  }
  // The last state of a run may be shown under the number that a longer run gives to another one.
  std::erase_if(frames_, [number](const FrameTime& frame) { return frame.number >= number; });
  frames_.push_back({number, time});
  if (format_.index != nullptr) write_atomically(folder_ / format_.index_name, format_.index(frames_));
}

}  // namespace pf
