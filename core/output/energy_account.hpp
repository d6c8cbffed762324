// The closed account of a run's energy as a file: what came in, and what the numerics made of it, by cause.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/files.hpp"
#include "core/runner.hpp"
#include "core/step_report.hpp"

namespace pf {

/// One column of the account: a cause, summed since the account began [J].
struct EnergyCause {
  std::string_view key;
  double (*of)(const EnergyLedger& ledger);
};
std::span<const EnergyCause> energy_causes();

/// Sums the causes over the states given one after the other; the first opens it. A state whose energies were not
/// counted (EnergyLedger::known) opens it anew.
class EnergyAccount {
 public:
  /// "step,time,kinetic_energy,elastic_energy,potential_energy,total_energy,change," then the causes, then
  /// "unaccounted": the change less all causes, which is rounding.
  static std::string header();
  /// The row of the state, in the header's order; time in s, all else but the step in J.
  std::vector<double> row(const StepReport& report);

 private:
  std::optional<double> opening_;
  std::array<double, 16> sums_{};
};

/// Those of `reports` (consecutive states) from the last one on that opens an account: all that can be closed.
std::span<const StepReport> accountable(std::span<const StepReport> reports);
std::string energy_account_csv(std::span<const StepReport> reports);
/// {"format": "pushforward/energy-account", "version": 1, "columns": [...], "rows": [[...], ...]}
std::string energy_account_json(std::span<const StepReport> reports);

/// energy.csv of a run: a row each state, from the first one seen.
class EnergyWriter : public RunObserver {
 public:
  explicit EnergyWriter(const std::filesystem::path& file);
  void on_state(const Simulation& simulation) override;
  void on_end(const Simulation& simulation, const RunResult& result) override;

 private:
  OutputFile file_;
  EnergyAccount account_;
};

}  // namespace pf
