// One measured setting: a row of results.csv.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pf {

enum class RowStatus { ok, unstable, failed, timeout };
enum class RunClass { good, damped, growing, noisy, failed, blown_up };

inline constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

/// What was measured of one setting; NaN where something is not known. Errors are root mean squares over the compared
/// times of sqrt(sum m e^2 / sum m), or the largest of all particles and times.
struct StudyRow {
  std::size_t point = 0;  ///< which setting
  RowStatus status = RowStatus::ok;
  RunClass behaviour = RunClass::good;
  std::string reason;  ///< why a run is not ok, "" where it is
  double wall = not_measured, wall_min = not_measured, wall_max = not_measured;  ///< of the steps [s]
  double work = not_measured;                                                  ///< weighted particle visits (work.hpp)
  double error_l2 = not_measured, error_max = not_measured;                    ///< position [m]
  double error_velocity_l2 = not_measured, error_velocity_max = not_measured;  ///< [m/s]
  double error_F_l2 = not_measured, error_F_max = not_measured;
  double error_stress_l2 = not_measured, error_stress_max = not_measured;  ///< Cauchy [Pa]
  double energy_lost = not_measured, energy_gained = not_measured;         ///< share of the energy at play
  double energy_change = not_measured;  ///< the same with its sign, at the last time of which it is known
  double momentum_drift = not_measured, angular_drift = not_measured;  ///< share of what moves
  double stress_noise = not_measured, velocity_noise = not_measured;   ///< share of the rms
  /// Displacement at the end of the point that the first probe was put at, as its particle's motion carries it: x_p +
  /// F_p (at - X_p), from where that was at first [m].
  double probe_ux = not_measured, probe_uy = not_measured, probe_uz = not_measured;
  double probe_period = not_measured;  ///< of its swing, along the axis on which it moves most [s]
  double steps = 0, newton_iterations = 0, linear_iterations = 0, retries = 0;
  double end_time = 0;                          ///< reached [s]
  double dt = not_measured, dx = not_measured;  ///< settings as run [s], [m]
  double particles = not_measured;
  double p2g = 0, g2p = 0, energy = 0, gradient = 0, tangent = 0, hessian_product = 0, diagonal = 0, assembly = 0,
         solver_operations = 0, stencil_operations = 0;  ///< StepReport::work
};

/// A column of numbers.
struct RowColumn {
  std::string_view name;   ///< in results.csv
  std::string_view title;  ///< on an axis
  std::string_view unit;
  double StudyRow::*member;
  bool timing = false;  ///< differs between two equal studies
};

/// Every number of a row, in file order.
std::span<const RowColumn> row_columns();
/// nullptr where there is none of that name.
const RowColumn* find_row_column(std::string_view name);
std::vector<std::string> row_column_names();

std::string_view name_of(RowStatus status);
std::string_view name_of(RunClass behaviour);

/// results.csv: the varied columns, then status, class, every number, and the reason.
std::string results_header(std::span<const std::string> varied);
/// `values`: texts of the varied columns.
std::string results_row(const StudyRow& row, std::span<const std::string> values);
/// The rows of a results.csv whose varied cells are `values_of[point]`; a row that fits no setting is left out.
std::vector<StudyRow> read_results(std::string_view csv, const std::string& source, std::span<const std::string> varied,
                                   std::span<const std::vector<std::string>> values_of);

}  // namespace pf
