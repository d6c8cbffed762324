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

Exporter::Exporter(const ExportFormat& format, std::filesystem::path folder, std::vector<double> earlier)
    : format_(format), folder_(std::move(folder)), times_(std::move(earlier)) {
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
  times_.resize(static_cast<std::size_t>(number));  // a continued run shows the last frame once more
  times_.push_back(time);
  if (format_.index != nullptr) write_atomically(folder_ / format_.index_name, format_.index(times_));
}

}  // namespace pf
