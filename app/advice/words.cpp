#include "app/advice/words.hpp"

#include <cmath>

#include "app/widgets/choices.hpp"
#include "app/widgets/units.hpp"

namespace pf::app {

namespace {

std::string percent(double ratio) {
  return quantity(100 * ratio, "", ratio < 0.1 ? 1 : 2) + " %";
}

}  // namespace

std::string evidence(const AdviceReport& report, const Trial& trial) {
  const Trial& now = report.trials.front();
  const std::string work = trial.work == 0 ? "No more work" : percent(trial.work / now.work) + " of the work";
  return work + ". Error " + quantity(trial.error, "m", 3) + " after " + quantity(report.span, "s", 3) + ", as it is " +
         quantity(now.error, "m", 3) + ".";
}

std::string basis_of_judgement(const AdviceReport& report) {
  if (!report.why_none.empty()) return {};
  std::string text = "Trials went on from t = " + quantity(report.time, "s", 4) + " for " +
                     quantity(report.span, "s", 3) +
                     ", each with something changed. Errors are distances from a run with finer steps (root mean "
                     "square over the mass), and what that one leaves open, " +
                     quantity(report.reference_open, "m", 3) + ".";
  if (!report.other_basis.empty())
    text += " Every error holds what the grid leaves open, too, " + quantity(report.grid_open, "m", 3) +
            ": so far apart are the answers of this basis and of another one on it (" +
            choice_label("/grid/basis", report.other_basis) + ").";
  return text;
}

std::string no_advice(const AdviceReport& report) {
  if (!report.why_none.empty()) return report.why_none;
  if (!report.advice.empty()) return {};
  return "No more than the scene needs: of " + std::to_string(report.trials.size() - 1) +
         " changes tried, none is cheaper and as exact.";
}

std::string resting_words(const AdviceReport& report) {
  if (report.resting == 0) return {};
  if (report.resting == 1) return "All cells are at rest.";
  return percent(report.resting) + " of the cells are at rest.";
}

}  // namespace pf::app
