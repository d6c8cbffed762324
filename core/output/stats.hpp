// stats.csv and probes.csv: what each step did, to the letter of INTERFACE.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "core/files.hpp"
#include "core/runner.hpp"

namespace pf {

/// What a scene's stats.csv has besides what all have.
struct StatsColumns {
  int dimension = 2;
  bool exact = false, adaptive = false;
  bool strokes = false;  ///< its events cut or paint
};
StatsColumns stats_columns(const Scene& scene);

/// First line of stats.csv, without its end. In 2D momentum_z and angular momentum about x and y are left out;
/// errors are there where the scene has an exact motion, and with adaptive steps what was chosen and why:
/// integrator,limited_by,error_rate,explicit_limit,implicit_cost,explicit_cost,given_up (ControlReport). Where events
/// cut or paint, what that has taken out of the run so far:
/// cut_particles,painted_particles,removed_mass,removed_energy,
/// removed_momentum_x,removed_momentum_y[,removed_momentum_z] (StrokeSums). Last of all stable_step: what an explicit
/// step could be [s], in the rows whose step is a multiple of stable_step_rows, empty in the others; and converged: 1
/// where Newton's residual came below the tolerance (an explicit step has none to bring down), 0 where it stopped at
/// what rounding leaves of it.
std::string stats_header(const StatsColumns& columns);
/// One row, without its end.
std::string stats_row(const StepReport& report, const StatsColumns& columns, std::optional<double> stable_step = {},
                      bool converged = true);
/// How often stable_step is worked out: it costs as much as a few implicit steps.
inline constexpr long stable_step_rows = 50;

/// First line of probes.csv.
std::string probes_header(int dimension);

/// A row each state. Rows up to `kept_step` are in the file already (a run that is continued in its own folder).
class StatsWriter : public RunObserver {
 public:
  StatsWriter(const std::filesystem::path& file, const Scene& scene, std::optional<long> kept_step = {});
  void on_state(const Simulation& simulation) override;
  void on_end(const Simulation& simulation, const RunResult& result) override;

 private:
  OutputFile file_;
  StatsColumns columns_;
  long kept_step_;
};

/// A row each probe and state.
class ProbesWriter : public RunObserver {
 public:
  ProbesWriter(const std::filesystem::path& file, const Scene& scene, std::optional<long> kept_step = {});
  void on_state(const Simulation& simulation) override;
  void on_end(const Simulation& simulation, const RunResult& result) override;

 private:
  OutputFile file_;
  long kept_step_;
};

/// Before continuing in the folder of an earlier run: drops the rows after `step` (stats.csv) or after `time`
/// (probes.csv). False, and nothing done, where the file is not there, has another header, or no row of that step.
bool keep_stats_until(const std::filesystem::path& file, const std::string& header, long step, double time);
bool keep_probes_until(const std::filesystem::path& file, const std::string& header, double time);

}  // namespace pf
