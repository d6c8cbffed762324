#include "core/advice/rules.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/integrators/integrator.hpp"
#include "core/params/pointer.hpp"

namespace pf {

namespace {

using Proposals = std::vector<Proposal>;

constexpr std::array longer{2, 4, 8};
constexpr std::array longer_implicit{8, 32, 128};  ///< than explicit ones
/// Of the explicit limit: it moves as the material does.
constexpr double explicit_margin = 0.8;
/// Above it linear elasticity is not worth a trial.
constexpr double small_strain = 0.1;

bool is_implicit(const Scene& scene) {
  return find_integrator(scene.integrator.type)->implicit;
}
bool has_inertia(const Scene& scene) {
  return find_integrator(scene.integrator.type)->inertia;
}
bool has_fixed_steps(const Scene& scene) {
  return scene.time.control == "fixed";
}

std::string lower_label(std::string_view label) {
  std::string text(label);
  // Abbreviations stay as they are.
  if (text.size() > 1 && std::islower(static_cast<unsigned char>(text[1])) != 0)
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}
/// Eponyms stay as they are.
std::string integrator_label(std::string_view name) {
  const std::string label(find_integrator(name)->label);
  return name == "backward_euler" || name == "symplectic_euler" ? label : lower_label(label);
}

std::string times(int factor) {
  return "steps " + std::to_string(factor) + " times as long";
}
std::string short_number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2g", value);
  return text.data();
}
/// To two digits, downwards.
double rounded_down(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::stod(short_number(std::floor(value / unit * (1 + 1e-12)) * unit));
}

Proposals longer_steps(const AdviceFacts& facts) {
  Proposals out;
  if (!has_fixed_steps(facts.scene)) return out;
  for (const int factor : longer) {
    const double step = factor * facts.step;
    if (!is_implicit(facts.scene) && step > explicit_margin * facts.explicit_limit) break;
    out.push_back({times(factor), {{"/time/step", step}}});
  }
  return out;
}

Proposals second_order(const AdviceFacts& facts) {
  Proposals out;
  if (!has_fixed_steps(facts.scene) || !has_inertia(facts.scene) || !is_implicit(facts.scene)) return out;
  for (const std::string_view name : {"implicit_midpoint", "tr_bdf2", "generalized_alpha"}) {
    if (name == facts.scene.integrator.type) continue;
    const std::string label = integrator_label(name);
    out.push_back({label, {{"/integrator/type", name}}});
    for (const int factor : longer)
      out.push_back({label + ", " + times(factor), {{"/integrator/type", name}, {"/time/step", factor * facts.step}}});
  }
  return out;
}

Proposals go_explicit(const AdviceFacts& facts) {
  const Scene& scene = facts.scene;
  const double limit = facts.explicit_limit;
  if (!is_implicit(scene) || !has_inertia(scene) || !has_fixed_steps(scene) || !(limit > 0) || !std::isfinite(limit))
    return {};
  const double step = rounded_down(std::min(explicit_margin * limit, longer.back() * facts.step));
  Proposal proposal{"symplectic Euler, steps of " + short_number(step) + " s",
                    {{"/integrator/type", "symplectic_euler"}, {"/time/step", step}}};
  // With the consistent mass an explicit step solves a system, and its limit is another one.
  if (scene.integrator.mass != "lumped") proposal.edits.push_back({"/integrator/mass", "lumped"});
  return {proposal};
}

Proposals go_implicit(const AdviceFacts& facts) {
  Proposals out;
  if (is_implicit(facts.scene) || !has_fixed_steps(facts.scene)) return out;
  for (const std::string_view name : {"backward_euler", "implicit_midpoint"})
    for (const int factor : longer_implicit)
      out.push_back({integrator_label(name) + ", " + times(factor),
                     {{"/integrator/type", name}, {"/time/step", factor * facts.step}}});
  return out;
}

Proposals without_inertia(const AdviceFacts& facts) {
  if (!has_inertia(facts.scene) || !is_implicit(facts.scene)) return {};
  return {{"quasi-static", {{"/integrator/type", "quasi_static"}}}};
}

Proposals smaller_basis(const AdviceFacts& facts) {
  struct Smaller {
    std::string_view than, basis, title;
  };
  static constexpr std::array table{
      Smaller{"cubic", "quadratic", "quadratic B-splines"},
      Smaller{"cubic", "linear", "linear functions"},
      Smaller{"quadratic", "linear", "linear functions"},
      Smaller{"quadratic_gimp", "quadratic", "quadratic B-splines at the particles' centres"},
      Smaller{"quadratic_gimp", "gimp", "linear functions averaged"},
      Smaller{"gimp", "linear", "linear functions at the particles' centres"},
  };
  Proposals out;
  for (const Smaller& s : table)
    if (s.than == facts.scene.grid.basis) out.push_back({std::string(s.title), {{"/grid/basis", s.basis}}});
  return out;
}

Proposals plain_walls(const AdviceFacts& facts) {
  if (!facts.scene.grid.boundary_correction) return {};
  return {{"the bases' correction at walls", {{"/grid/boundary_correction", false}}}};
}

Proposals lumped_mass(const AdviceFacts& facts) {
  Proposals out;
  const bool inertia = facts.scene.integrator.mass == "consistent",
             velocity = facts.scene.transfer.velocity_mass == "consistent";
  if (inertia) out.push_back({"lumped mass in the inertia", {{"/integrator/mass", "lumped"}}});
  if (velocity) out.push_back({"lumped mass in the transfer", {{"/transfer/velocity_mass", "lumped"}}});
  return out;
}

Proposals looser_newton(const AdviceFacts& facts) {
  Proposals out;
  if (!is_implicit(facts.scene)) return out;
  constexpr double loosest = 1e-3;
  for (const double factor : {10.0, 100.0, 1000.0}) {
    const double tolerance = std::stod(short_number(factor * facts.scene.solver.newton_tolerance));
    if (tolerance > loosest * (1 + 1e-12)) break;
    out.push_back({"a Newton tolerance of " + short_number(tolerance), {{"/solver/newton_tolerance", tolerance}}});
  }
  return out;
}

Proposals chosen_solver(const AdviceFacts& facts) {
  if (!is_implicit(facts.scene) || facts.scene.solver.linear == "auto") return {};
  return {{"automatic", {{"/solver/linear", "auto"}}}};
}

Proposals without_f_bar(const AdviceFacts& facts) {
  Proposal proposal{"F-bar", {}};
  for (const Material& material : facts.scene.materials)
    if (material.f_bar) proposal.edits.push_back({"/materials" + pointer_step(material.name) + "/f_bar", false});
  if (proposal.edits.empty()) return {};
  return {proposal};
}

Proposals linear_law(const AdviceFacts& facts) {
  if (facts.largest_strain > small_strain) return {};
  Proposal proposal{"linear elasticity", {}};
  for (const Material& material : facts.scene.materials) {
    if (material.model != "linear_elastic")
      proposal.edits.push_back({"/materials" + pointer_step(material.name) + "/model", "linear_elastic"});
  }
  if (proposal.edits.empty()) return {};
  return {proposal};
}

constexpr std::array table{
    AdviceRule{"steps", "Take {}", longer_steps},
    AdviceRule{"integrator", "Change the integrator: {}", second_order},
    AdviceRule{"explicit", "Go explicit: {}", go_explicit},
    AdviceRule{"implicit", "Go implicit: {}", go_implicit},
    AdviceRule{"inertia", "Leave inertia out: {}", without_inertia},
    AdviceRule{"basis", "A smaller basis is enough: {}", smaller_basis},
    AdviceRule{"walls", "Leave out {}", plain_walls},
    AdviceRule{"mass", "Be content with {}", lumped_mass},
    AdviceRule{"newton", "Solve less exactly: {}", looser_newton},
    AdviceRule{"solver", "Let the linear solver be chosen: {}", chosen_solver},
    AdviceRule{"f_bar", "Leave out {}", without_f_bar},
    AdviceRule{"law", "A simpler law is enough: {}", linear_law},
};

}  // namespace

std::span<const AdviceRule> advice_rules() {
  return table;
}

int trial_steps(const AdviceFacts& facts) {
  if (!is_implicit(facts.scene)) return longer_implicit.back();
  constexpr double waves = 20;  // explicit limits: about as many cells
  constexpr int most = 8;       // of the longest steps
  const double times = waves * facts.explicit_limit / (facts.step * longer.back());
  return longer.back() * static_cast<int>(std::ceil(std::clamp(times, 1.0, double{most})));
}

std::string_view other_basis(std::string_view basis) {
  if (basis == "quadratic") return "cubic";
  if (basis == "gimp") return "quadratic_gimp";
  if (basis == "quadratic_gimp") return "cubic";
  return "quadratic";
}

}  // namespace pf
