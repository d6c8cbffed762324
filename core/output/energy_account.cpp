#include "core/output/energy_account.hpp"

#include <nlohmann/json.hpp>

namespace pf {

namespace {

// clang-format off
constexpr std::array causes{
    EnergyCause{"loads", [](const EnergyLedger& e) { return e.loads; }},
    EnergyCause{"walls_and_supports", [](const EnergyLedger& e) { return e.boundary; }},
    EnergyCause{"mouse", [](const EnergyLedger& e) { return e.mouse; }},
    EnergyCause{"edits", [](const EnergyLedger& e) { return e.edits; }},
    EnergyCause{"strokes", [](const EnergyLedger& e) { return e.strokes; }},
    EnergyCause{"time_integration", [](const EnergyLedger& e) { return e.time_integration; }},
    EnergyCause{"to_grid", [](const EnergyLedger& e) { return e.to_grid; }},
    EnergyCause{"to_particles", [](const EnergyLedger& e) { return e.to_particles; }},
    EnergyCause{"solver", [](const EnergyLedger& e) { return e.solver; }},
};
// clang-format on

std::string csv_row(const std::vector<double>& row) {
  std::string text = std::to_string(static_cast<long>(row[0]));
  for (std::size_t k = 1; k < row.size(); ++k) {
    text += ',';
    append_number(text, row[k]);
  }
  return text + '\n';
}

}  // namespace

std::span<const EnergyCause> energy_causes() {
  return causes;
}

std::string EnergyAccount::header() {
  std::string text = "step,time,kinetic_energy,elastic_energy,potential_energy,total_energy,change";
  for (const EnergyCause& cause : causes) text += "," + std::string(cause.key);
  return text + ",unaccounted";
}

std::vector<double> EnergyAccount::row(const StepReport& report) {
  const Balance& balance = report.balance;
  if (!opening_ || !report.energy.known) {
    opening_ = balance.total();
    sums_ = {};
  } else {
    for (std::size_t k = 0; k < causes.size(); ++k) sums_[k] += causes[k].of(report.energy);
  }
  const double change = balance.total() - *opening_;
  std::vector<double> row{static_cast<double>(report.step),
                          report.time,
                          balance.kinetic,
                          balance.elastic,
                          balance.potential,
                          balance.total(),
                          change};
  double rest = change;
  for (std::size_t k = 0; k < causes.size(); ++k) {
    row.push_back(sums_[k]);
    rest -= sums_[k];
  }
  row.push_back(rest);
  return row;
}

std::span<const StepReport> accountable(std::span<const StepReport> reports) {
  std::size_t first = reports.size();
  while (first > 1 && reports[first - 1].energy.known) --first;
  if (first >= reports.size() || first == 0) return {};
  return reports.subspan(first - 1);
}

std::string energy_account_csv(std::span<const StepReport> reports) {
  EnergyAccount account;
  std::string text = EnergyAccount::header() + '\n';
  for (const StepReport& report : accountable(reports)) text += csv_row(account.row(report));
  return text;
}

std::string energy_account_json(std::span<const StepReport> reports) {
  nlohmann::ordered_json document{{"format", "pushforward/energy-account"}, {"version", 1}};
  std::string name;
  for (const char c : EnergyAccount::header() + ",") {
    if (c != ',') {
      name += c;
      continue;
    }
    document["columns"].push_back(name);
    name.clear();
  }
  EnergyAccount account;
  document["rows"] = nlohmann::ordered_json::array();
  for (const StepReport& report : accountable(reports)) document["rows"].push_back(account.row(report));
  return document.dump() + '\n';
}

EnergyWriter::EnergyWriter(const std::filesystem::path& file) : file_(file) {
  file_.write(EnergyAccount::header() + '\n');
}

void EnergyWriter::on_state(const Simulation& simulation) {
  file_.write(csv_row(account_.row(simulation.report())));
  file_.flush();
}

void EnergyWriter::on_end(const Simulation& /*simulation*/, const RunResult& /*result*/) {
  file_.close();
}

}  // namespace pf
