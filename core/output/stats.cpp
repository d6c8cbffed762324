#include "core/output/stats.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "core/output/csv_table.hpp"

namespace pf {

namespace {

namespace fs = std::filesystem;

void add(std::string& row, double value) {
  row += ',';
  append_number(row, value);
}
void add(std::string& row, long value) {
  row += ',' + std::to_string(value);
}

OutputFile::Mode mode(const std::optional<long>& kept_step) {
  return kept_step ? OutputFile::Mode::append : OutputFile::Mode::replace;
}

}  // namespace

StatsColumns stats_columns(const Scene& scene) {
  return {.dimension = scene.dimension,
          .exact = !scene.exact_position.empty(),
          .adaptive = scene.time.control == "adaptive",
          .strokes = std::any_of(scene.events.begin(), scene.events.end(),
                                 [](const Event& event) { return !event.strokes.empty(); })};
}

std::string stats_header(const StatsColumns& columns) {
  std::string header =
      "step,time,dt,newton_iterations,linear_iterations,residual,kinetic_energy,elastic_energy,potential_energy,"
      "total_energy,momentum_x,momentum_y,";
  if (columns.dimension == 3) header += "momentum_z,angular_momentum_x,angular_momentum_y,";
  header += "angular_momentum_z,min_J,max_J,active_nodes,cfl,wall_ms";
  if (columns.exact) header += ",error_l2,error_max,error_velocity_l2,error_F_l2";
  if (columns.adaptive)
    header += ",integrator,limited_by,error_rate,explicit_limit,implicit_cost,explicit_cost,given_up";
  if (columns.strokes) {
    header += ",cut_particles,painted_particles,removed_mass,removed_energy,removed_momentum_x,removed_momentum_y";
    if (columns.dimension == 3) header += ",removed_momentum_z";
  }
  return header + ",stable_step,converged";
}

std::string stats_row(const StepReport& report, const StatsColumns& columns, std::optional<double> stable_step,
                      bool converged) {
  const Balance& balance = report.balance;
  std::string row = std::to_string(report.step);
  add(row, report.time);
  add(row, report.dt);
  add(row, static_cast<long>(report.newton.size()));
  add(row, static_cast<long>(report.linear_iterations));
  for (const double value : {report.residual, balance.kinetic, balance.elastic, balance.potential, balance.total(),
                             balance.momentum.x(), balance.momentum.y()})
    add(row, value);
  if (columns.dimension == 3)
    for (const double value : {balance.momentum.z(), balance.angular_momentum.x(), balance.angular_momentum.y()})
      add(row, value);
  for (const double value : {balance.angular_momentum.z(), report.min_J, report.max_J}) add(row, value);
  add(row, static_cast<long>(report.active_nodes));
  add(row, report.cfl);
  add(row, report.ms.total);
  if (columns.exact)
    for (const double value : {report.error.l2, report.error.max, report.error.velocity_l2, report.error.F_l2})
      add(row, value);
  if (columns.adaptive) {
    // The initial state was not chosen, nor was a step after an event that made them fixed.
    const ControlReport& control = report.control;
    const bool chosen = control.adaptive && report.dt > 0;
    row += chosen ? (control.implicit ? ",implicit," : ",explicit,") + std::string(name_of(control.limited_by)) : ",,";
    for (const double value :
         {control.error_rate, control.explicit_limit, control.implicit_cost, control.explicit_cost})
      add(row, value);
    add(row, static_cast<long>(control.given_up));
  }
  if (columns.strokes) {
    const StrokeSums& sums = report.strokes;
    add(row, static_cast<long>(sums.cut));
    add(row, static_cast<long>(sums.painted));
    for (const double value : {sums.mass, sums.energy}) add(row, value);
    for (int a = 0; a < columns.dimension; ++a) add(row, sums.momentum[a]);
  }
  row += ',';
  if (stable_step) append_number(row, *stable_step);
  return row + (converged ? ",1" : ",0");
}

std::string probes_header(int dimension) {
  return dimension == 3 ? "time,probe,x,y,z,vx,vy,vz,sxx,syy,szz,sxy,syz,sxz" : "time,probe,x,y,vx,vy,sxx,syy,szz,sxy";
}

StatsWriter::StatsWriter(const fs::path& file, const Scene& scene, std::optional<long> kept_step)
    : file_(file, mode(kept_step)), columns_(stats_columns(scene)), kept_step_(kept_step.value_or(-1)) {
  if (!kept_step) file_.write(stats_header(columns_) + '\n');
}

void StatsWriter::on_state(const Simulation& simulation) {
  if (simulation.report().step <= kept_step_) return;
  const StepReport& report = simulation.report();
  const bool converged = report.newton.empty() || report.residual <= simulation.scene().solver.newton_tolerance;
  std::optional<double> stable_step;
  if (report.step % stable_step_rows == 0) stable_step = simulation.stable_step();
  file_.write(stats_row(report, columns_, stable_step, converged) + '\n');
  file_.flush();
}

void StatsWriter::on_end(const Simulation& /*simulation*/, const RunResult& /*result*/) {
  file_.close();
}

ProbesWriter::ProbesWriter(const fs::path& file, const Scene& scene, std::optional<long> kept_step)
    : file_(file, mode(kept_step)), kept_step_(kept_step.value_or(-1)) {
  if (!kept_step) file_.write(probes_header(scene.dimension) + '\n');
}

void ProbesWriter::on_state(const Simulation& simulation) {
  if (simulation.report().step <= kept_step_) return;
  const Scene& scene = simulation.scene();
  std::string rows;
  for (const ProbeReading& reading : simulation.probes()) {
    append_number(rows, simulation.time());
    rows += ',' + csv_cell(scene.probes[reading.probe].name);
    for (const Vec3* vector : {&reading.x, &reading.v})
      for (int a = 0; a < scene.dimension; ++a) add(rows, (*vector)[a]);
    const Mat3& s = reading.sigma;
    for (const double value : {s(0, 0), s(1, 1), s(2, 2), s(0, 1)}) add(rows, value);
    if (scene.dimension == 3)
      for (const double value : {s(1, 2), s(0, 2)}) add(rows, value);
    rows += '\n';
  }
  file_.write(rows);
  file_.flush();
}

void ProbesWriter::on_end(const Simulation& /*simulation*/, const RunResult& /*result*/) {
  file_.close();
}

bool keep_stats_until(const fs::path& file, const std::string& header, long step, double time) {
  if (!fs::exists(file)) return false;
  std::istringstream text(read_file(file));
  std::string line, kept;
  if (!std::getline(text, line) || line != header) return false;
  kept = line + '\n';
  std::string wanted = std::to_string(step);
  add(wanted, time);
  wanted += ',';
  while (std::getline(text, line)) {
    kept += line + '\n';
    if (line.starts_with(wanted)) {
      write_atomically(file, kept);
      return true;
    }
  }
  return false;
}

bool keep_probes_until(const fs::path& file, const std::string& header, double time) {
  if (!fs::exists(file)) return false;
  std::istringstream text(read_file(file));
  std::string line, kept;
  if (!std::getline(text, line) || line != header) return false;
  kept = line + '\n';
  while (std::getline(text, line))
    if (std::strtod(line.c_str(), nullptr) <= time) kept += line + '\n';
  write_atomically(file, kept);
  return true;
}

}  // namespace pf
