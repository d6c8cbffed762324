// Energy balance: what came in, what the numerics made of it, summed over time; it adds up to the change.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/panels/memory.hpp"
#include "app/panels/panels.hpp"
#include "app/panels/series.hpp"
#include "app/preferences.hpp"
#include "app/widgets/plot.hpp"
#include "app/widgets/run_list.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"
#include "core/output/energy_account.hpp"
#include "core/params/problem.hpp"

namespace pf::app {

namespace {

struct Cause {
  const char* name;
  const char* help;
  double (*of)(const EnergyLedger&);
  std::size_t color;
  bool numeric;  ///< made by the numerics, dashed
};

double transfers_of(const EnergyLedger& e) {
  return e.to_grid + e.to_particles;
}

// clang-format off
const std::array causes{
    Cause{"Loads", "Work of tractions and body forces. Gravity's is the fall of the potential energy.",
          [](const EnergyLedger& e) { return e.loads; }, 1, false},
    Cause{"Walls and supports", "Work of walls and constraints: friction takes, what is moved gives.",
          [](const EnergyLedger& e) { return e.boundary; }, 2, false},
    Cause{"Mouse", "Work of the mouse's spring.", [](const EnergyLedger& e) { return e.mouse; }, 3, false},
    Cause{"Edits", "What changed settings made of the energy that was there: a stiffer material has more of it.",
          [](const EnergyLedger& e) { return e.edits; }, 6, false},
    Cause{"Cut and painted", "Went with the material that was cut away, or came with another one that was painted.",
          [](const EnergyLedger& e) { return e.strokes; }, 6, false},
    Cause{"Time steps", "Lost or gained by the time scheme: backward Euler damps, the more the longer the step.",
          [](const EnergyLedger& e) { return e.time_integration; }, 4, true},
    Cause{"Transfers", "Lost or gained between particles and grid: PIC smooths motion away, APIC and FLIP keep more of it.",
          transfers_of, 5, true},
    Cause{"Solver", "Left unbalanced by Newton's method: its tolerance decides.",
          [](const EnergyLedger& e) { return e.solver; }, 7, true}};
// clang-format on

/// Of the newest steps without a gap in the counting.
struct Account {
  std::vector<double> time, change;
  std::array<std::vector<double>, causes.size()> sums;
  bool whole = false;  ///< from the start of the run
};

Account account_of(const std::vector<StepReport>& reports) {
  Account a;
  std::size_t first = reports.size();
  while (first > 1 && reports[first - 1].energy.known) --first;
  if (first >= reports.size() || first == 0) return a;
  a.whole = reports[first - 1].step == 0;
  const double before = reports[first - 1].balance.total();
  a.time.push_back(reports[first - 1].time);
  a.change.push_back(0);
  for (auto& sum : a.sums) sum.push_back(0);
  for (std::size_t k = first; k < reports.size(); ++k) {
    a.time.push_back(reports[k].time);
    a.change.push_back(reports[k].balance.total() - before);
    for (std::size_t c = 0; c < causes.size(); ++c)
      a.sums[c].push_back(a.sums[c].back() + causes[c].of(reports[k].energy));
  }
  return a;
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

/// Loads, mouse and edits are shown where there are some: more than the rounding of what else was summed.
bool shown(const Account& a, std::size_t cause) {
  if (causes[cause].numeric || causes[cause].name == std::string_view("Walls and supports")) return true;
  double all = largest(a.change);
  for (const auto& sum : a.sums) all = std::max(all, largest(sum));
  return largest(a.sums[cause]) > 1e-9 * all;
}

/// What the numerics made of it in all, against the most energy that the bodies had.
std::string verdict(const Account& a, const std::vector<StepReport>& reports) {
  double made = 0, most = 0;
  for (std::size_t c = 0; c < causes.size(); ++c)
    if (causes[c].numeric) made += a.sums[c].back();
  for (const StepReport& r : reports) most = std::max(most, r.balance.kinetic + r.balance.elastic);
  if (!(most > 0)) return "";
  return std::string(made <= 0 ? "The numerics lost " : "The numerics made ") + quantity(std::abs(made), "J", 3) +
         ", " + quantity(100 * std::abs(made) / most, "", 2) + " % of the largest kinetic and elastic energy.";
}

/// The account as it stands, beside the pictures.
void save_account(AppContext& context, bool json) {
  const auto& reports = context.current.reports;
  const auto file =
      free_file(context.save_folder, file_stem(context.scene.name, "scene") + "-energy", json ? ".json" : ".csv");
  try {
    write_atomically(file, json ? energy_account_json(reports) : energy_account_csv(reports));
    context.notify("Saved " + file.string());
  } catch (const FileError& error) {
    context.notify(error.what());
  }
}

void draw_list(AppContext& context, const Account& a) {
  legend_entry(context, 0, "Change of the energy", newest(a.change, "J"));
  for (std::size_t c = 0; c < causes.size(); ++c) {
    if (!shown(a, c)) continue;
    legend_entry(context, causes[c].color, causes[c].name, newest(a.sums[c], "J"), nullptr, causes[c].numeric);
    tooltip(causes[c].help);
  }
  if (context.snapshot && context.snapshot->report.strokes.count > 0) {
    const StrokeSums& strokes = context.snapshot->report.strokes;
    property("Mass that was cut or painted away", quantity(strokes.mass, "kg", 3));
    tooltip(std::to_string(strokes.cut) + " particles were cut away, " + std::to_string(strokes.painted) +
            " painted. What painting with a denser material brings counts as negative.");
  }
  gap(0.25F);
  if (!a.time.empty()) {
    muted(verdict(a, context.current.reports));
    if (text_button("Save as CSV")) save_account(context, false);
    tooltip("The sums over time, a row a step, with what remains: rounding.");
    ImGui::SameLine();
    if (text_button("JSON")) save_account(context, true);
  }
  if (a.whole || context.current.reports.size() < 2) return;
  muted(a.time.empty() ? "Counted from the next step on."
                       : "Counted since t = " + quantity(a.time.front(), "s", 4) + ".");
  if (text_button("Count from the start")) context.session.recount();
  tooltip("Simulates the run again, to the same bytes, and counts on the way.");
}

}  // namespace

void draw_balance_plot(AppContext& context) {
  PlotMemory& m = memory(context).plots;
  const Account account = account_of(context.current.reports);
  if (begin_run_list()) {
    draw_list(context, account);
    end_run_list();
  }
  Chart chart = time_chart("Energy since the start", "J");
  chart.y.include_zero = true;
  for (std::size_t c = 0; c < causes.size(); ++c)
    if (shown(account, c))
      add_series(chart, causes[c].name, account.time, account.sums[c], causes[c].color, Role::current,
                 causes[c].numeric);
  add_series(chart, "Change of the energy", account.time, account.change, 0, Role::current);
  plot(context, "energy-balance", std::move(chart), m.balance_view);
}

}  // namespace pf::app
