#include "core/studies/row.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/files.hpp"
#include "core/output/csv_table.hpp"

namespace pf {

namespace {

constexpr RowColumn table[] = {
    {"wall_s", "Wall time", "s", &StudyRow::wall, true},
    {"wall_min_s", "Wall time, least", "s", &StudyRow::wall_min, true},
    {"wall_max_s", "Wall time, most", "s", &StudyRow::wall_max, true},
    {"work", "Work", "weighted particle visits", &StudyRow::work},
    {"error_l2", "Position error (L²)", "m", &StudyRow::error_l2},
    {"error_max", "Position error (largest)", "m", &StudyRow::error_max},
    {"error_velocity_l2", "Velocity error (L²)", "m/s", &StudyRow::error_velocity_l2},
    {"error_velocity_max", "Velocity error (largest)", "m/s", &StudyRow::error_velocity_max},
    {"error_F_l2", "Error in F (L²)", "", &StudyRow::error_F_l2},
    {"error_F_max", "Error in F (largest)", "", &StudyRow::error_F_max},
    {"error_stress_l2", "Stress error (L²)", "Pa", &StudyRow::error_stress_l2},
    {"error_stress_max", "Stress error (largest)", "Pa", &StudyRow::error_stress_max},
    {"energy_lost", "Energy lost, share", "", &StudyRow::energy_lost},
    {"energy_gained", "Energy gained, share", "", &StudyRow::energy_gained},
    {"energy_change", "Energy change, share", "", &StudyRow::energy_change},
    {"momentum_drift", "Momentum drift, share", "", &StudyRow::momentum_drift},
    {"angular_drift", "Angular momentum drift, share", "", &StudyRow::angular_drift},
    {"stress_noise", "Stress noise, share", "", &StudyRow::stress_noise},
    {"velocity_noise", "Velocity noise, share", "", &StudyRow::velocity_noise},
    {"probe_ux", "Displacement of the first probe, x", "m", &StudyRow::probe_ux},
    {"probe_uy", "Displacement of the first probe, y", "m", &StudyRow::probe_uy},
    {"probe_uz", "Displacement of the first probe, z", "m", &StudyRow::probe_uz},
    {"probe_period", "Period of the first probe", "s", &StudyRow::probe_period},
    {"steps", "Steps", "", &StudyRow::steps},
    {"newton_iterations", "Newton iterations", "", &StudyRow::newton_iterations},
    {"linear_iterations", "Linear iterations", "", &StudyRow::linear_iterations},
    {"retries", "Steps begun again", "", &StudyRow::retries},
    {"end_time", "Time reached", "s", &StudyRow::end_time},
    {"dt", "Time step", "s", &StudyRow::dt},
    {"dx", "Grid spacing", "m", &StudyRow::dx},
    {"particles", "Particles", "", &StudyRow::particles},
    {"visits_p2g", "Visits, particles to grid", "", &StudyRow::p2g},
    {"visits_g2p", "Visits, grid to particles", "", &StudyRow::g2p},
    {"visits_energy", "Visits, energy", "", &StudyRow::energy},
    {"visits_gradient", "Visits, gradient", "", &StudyRow::gradient},
    {"visits_tangent", "Visits, tangent", "", &StudyRow::tangent},
    {"visits_hessian_product", "Visits, Hessian product", "", &StudyRow::hessian_product},
    {"visits_diagonal", "Visits, diagonal blocks", "", &StudyRow::diagonal},
    {"visits_assembly", "Visits, assembly", "", &StudyRow::assembly},
    {"solver_operations", "Multiply-adds of the linear solver", "", &StudyRow::solver_operations},
    {"stencil_operations", "Multiply-adds of multigrid, single precision", "", &StudyRow::stencil_operations},
};

constexpr std::string_view statuses[] = {"ok", "unstable", "failed", "timeout"};
constexpr std::string_view behaviours[] = {"good", "damped", "growing", "noisy", "failed", "blown_up"};

template <class Enum, std::size_t N>
bool parse(const std::string& text, const std::string_view (&names)[N], Enum& value) {
  const auto found = std::find(std::begin(names), std::end(names), text);
  if (found == std::end(names)) return false;
  value = static_cast<Enum>(found - std::begin(names));
  return true;
}

/// The row in these cells, or false where one of them is not what was written.
bool parse_row(const CsvTable& csv, const std::vector<std::string>& cells, std::size_t varied, StudyRow& row) {
  if (!parse(cells[varied], statuses, row.status) || !parse(cells[varied + 1], behaviours, row.behaviour)) return false;
  for (const RowColumn& column : table) {
    const int at = csv.find(column.name);
    if (at < 0) return false;
    row.*column.member = csv_value(cells[static_cast<std::size_t>(at)]);
  }
  row.reason = cells.back();
  return true;
}

}  // namespace

std::span<const RowColumn> row_columns() {
  return table;
}

const RowColumn* find_row_column(std::string_view name) {
  for (const RowColumn& column : table)
    if (column.name == name) return &column;
  return nullptr;
}

std::vector<std::string> row_column_names() {
  std::vector<std::string> names;
  for (const RowColumn& column : table) names.emplace_back(column.name);
  return names;
}

std::string_view name_of(RowStatus status) {
  return statuses[static_cast<std::size_t>(status)];
}
std::string_view name_of(RunClass behaviour) {
  return behaviours[static_cast<std::size_t>(behaviour)];
}

std::string results_header(std::span<const std::string> varied) {
  std::string header;
  for (const std::string& name : varied) header += csv_cell(name) + ',';
  header += "status,class";
  for (const RowColumn& column : table) header += ',' + std::string(column.name);
  return header + ",reason";
}

std::string results_row(const StudyRow& row, std::span<const std::string> values) {
  std::string text;
  for (const std::string& value : values) text += csv_cell(value) + ',';
  text += std::string(name_of(row.status)) + ',' + std::string(name_of(row.behaviour));
  for (const RowColumn& column : table) {
    text += ',';
    if (!std::isnan(row.*column.member)) append_number(text, row.*column.member);
  }
  return text + ',' + csv_cell(row.reason);
}

std::vector<StudyRow> read_results(std::string_view text, const std::string& source,
                                   std::span<const std::string> varied,
                                   std::span<const std::vector<std::string>> values_of) {
  const CsvTable csv = parse_csv(text, source);
  std::map<std::vector<std::string>, std::size_t> points;
  for (std::size_t k = 0; k < values_of.size(); ++k) points.emplace(values_of[k], k);
  std::vector<StudyRow> rows;
  if (csv.header.size() < varied.size() + 3 || !std::equal(varied.begin(), varied.end(), csv.header.begin()))
    return rows;
  for (const auto& cells : csv.rows) {
    const auto found = points.find({cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(varied.size())});
    StudyRow row;
    if (found == points.end() || !parse_row(csv, cells, varied.size(), row)) continue;
    row.point = found->second;
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace pf
