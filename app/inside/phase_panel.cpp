// One step, taken apart: the phase in words and formulae, with the live numbers of the watched particle and node.
#include <imgui.h>

#include <Eigen/LU>
#include <string>

#include "app/inside/step_player.hpp"
#include "app/panels/numbers.hpp"
#include "app/panels/panels.hpp"
#include "app/theme.hpp"
#include "app/widgets/formula_text.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"
#include "core/look.hpp"

namespace pf::app {

namespace {

/// The particle and the node whose numbers are shown, in the record's arrays.
struct Watched {
  const StepPlayer& player;
  const StepRecord& record;
  int d;
  std::optional<std::size_t> particle, node;
  std::vector<NodeWeight> weights;  ///< of the particle at t^n
  double w = 0;                     ///< of the particle at the node

  Vec3 x() const { return entry(record.before.x, *particle, d); }
  Mat3 F(const std::vector<double>& values) const {
    Mat3 F = Mat3::Identity();
    const auto D = static_cast<std::size_t>(d);
    for (int b = 0; b < d; ++b)
      for (int a = 0; a < d; ++a) F(a, b) = values[*particle * D * D + static_cast<std::size_t>(a + d * b)];
    return F;
  }
};

Watched watched(const AppContext& context) {
  const StepPlayer& player = *context.slow;
  Watched w{player, player.record(), player.record().dimension, {}, {}, {}, 0};
  if (context.selected_particle) w.particle = player.find_particle(*context.selected_particle);
  if (context.selected_node) w.node = player.find_node(*context.selected_node);
  if (w.particle) w.weights = recorded_weights(w.record, *w.particle);
  for (const NodeWeight& n : w.weights)
    if (context.selected_node == n.node) w.w = n.w;
  return w;
}

std::string particle_name(const AppContext& context) {
  return "Particle " + std::to_string(*context.selected_particle);
}
std::string node_name(const AppContext& context, int d) {
  return "Node " + index_text(*context.selected_node, d);
}

void bold(const std::string& text) {
  gap(0.4F);
  ImGui::PushFont(bold_font());
  paragraph(text);
  ImGui::PopFont();
}

void give(const AppContext& context, const Watched& w) {
  paragraph("Every particle spreads its mass and its momentum over the nodes about it, by their shape functions.");
  formula_text("m_i = \\sum_p m_p N_i(x_p)");
  const std::string transfer = w.player.scene().transfer.type;
  formula_text(transfer == "apic" ? "v_i = \\frac{1}{m_i} \\sum_p m_p N_i(x_p) ( v_p + C_p (x_i - x_p) )"
                                  : "v_i = \\frac{1}{m_i} \\sum_p m_p N_i(x_p) v_p");
  if (w.player.scene().transfer.velocity_mass == "consistent")
    muted("Here the consistent mass is used: \xe2\x88\x91 M v = \xe2\x88\x91 m N v is solved for v.");
  if (w.particle) {
    bold(particle_name(context));
    const double m = w.record.particle_mass[*w.particle];
    property("Mass", quantity(m, "kg"));
    property("Velocity", vector_text(entry(w.record.before.v, *w.particle, w.d), w.d, "m/s"));
    if (w.w > 0) property("gives the node", quantity(w.w, "", 3) + " \xc2\xb7 " + quantity(m, "kg", 3));
  }
  if (w.node) {
    bold(node_name(context, w.d));
    property("Mass", quantity(w.record.node_mass[*w.node], "kg"));
    property("Velocity", vector_text(entry(w.record.node_velocity, *w.node, w.d), w.d, "m/s"));
  }
  if (!foldable("How is N built on the grid?")) return;
  paragraph(
      "Of one B-spline an axis, centred on the node. Each spline is the one before it, averaged over a cell: the hat, "
      "then the smooth quadratic, then the cubic.");
  formula_text("N_i(x) = N(\\frac{x - x_i}{\\Delta x}) N(\\frac{y - y_i}{\\Delta x})");
  paragraph("For the body it is pulled back by the motion so far, and then this is finite elements as usual:");
  formula_text("\\hat{N}_i(X) = N_i( \\phi(X, t^n) )");
}

/// Three forces and what they leave, at the watched node.
void balance_table(const Watched& w, const IterateRecord& it) {
  const StageRecord& stage = w.record.stages[it.stage];
  const std::size_t i = *w.node;
  property("Inertia", vector_text(entry(it.inertia, i, w.d), w.d, "N"));
  property("Internal force", vector_text(entry(it.internal, i, w.d), w.d, "N"));
  property("Given forces", vector_text(entry(stage.given, i, w.d), w.d, "N"));
  tooltip("Gravity, loads, and where the scheme weighs them, forces of the step's beginning.");
  property("Left unbalanced", vector_text(entry(it.residual, i, w.d), w.d, "N"));
  tooltip("Inertia less the forces, without what walls and constraints take.");
}

void which_balance() {
  if (!foldable("Which balance is this?")) return;
  paragraph("That of momentum, on the reference body:");
  formula_text("R_0 \\frac{\\partial^2 \\phi}{\\partial t^2} = \\text{Div } P + R_0 g");
  paragraph("Tested with each node's function and integrated by parts, the stress leaves a surface term:");
  formula_text("\\int_{\\partial \\Omega_0} \\hat{N}_i P n \\, \\text{d}S");
  paragraph(
      "n is the outward normal there, not a shape function: this is where tractions enter. What is left over the "
      "volume "
      "is the internal force.");
}

void guess(const AppContext& context, const Watched& w) {
  paragraph(
      "The unknowns are where the nodes go. Without forces they would fly on; the new places minimise one energy, that "
      "of inertia and of the deformed body together.");
  formula_text("\\tilde{x} = x + \\Delta t v");
  formula_text(
      "E = \\frac{1}{2 \\Delta t^2} \\norm \\hat{x} - \\tilde{x} \\norm_M^2 + \\sum_p V_p \\psi(F_p) - f \\cdot "
      "\\hat{x}");
  const IterateRecord& it = w.record.iterates[0];
  gap(0.3F);
  property("Energy E", quantity(it.newton.energy, "J"));
  property("Relative residual", quantity(it.newton.residual, "", 3));
  if (w.node) {
    bold(node_name(context, w.d));
    property("Moved by", vector_text(entry(it.u, *w.node, w.d), w.d, "m"));
    balance_table(w, it);
  }
  which_balance();
}

void iterate(const AppContext& context, const Watched& w, const Phase& phase) {
  const IterateRecord &before = w.record.iterates[phase.iterate - 1], &it = w.record.iterates[phase.iterate];
  paragraph("The forces left over, in red, and how they change with the nodes' places say where the balance lies.");
  formula_text("H \\delta = - g,   \\hat{x} \\to \\hat{x} + \\alpha \\delta");
  formula_text(
      "g_i = \\sum_j \\frac{M_{ij} (\\hat{x}_j - \\tilde{x}_j)}{\\Delta t^2} - f_i^{int}(\\hat{x}) - f_i^{ext}");
  gap(0.3F);
  property("Relative residual",
           quantity(before.newton.residual, "", 3) + " \xe2\x86\x92 " + quantity(it.newton.residual, "", 3));
  property("Energy E", quantity(it.newton.energy, "J", 6));
  property("Step length \xce\xb1", quantity(before.newton.step_length, "", 3));
  if (before.newton.linear_iterations > 0)
    property("Linear iterations", std::to_string(before.newton.linear_iterations));
  if (before.newton.projected > 0)
    muted("The true H was indefinite: made positive definite at " + quantity(100 * before.newton.projected, "%", 2) +
          " of the nodes.");
  property("Tolerance", quantity(w.player.scene().solver.newton_tolerance, "", 2));
  if (w.node) {
    bold(node_name(context, w.d));
    property("Moved by", vector_text(entry(it.u, *w.node, w.d), w.d, "m"));
    balance_table(w, it);
  }
  which_balance();
}

void kick(const AppContext& context, const Watched& w) {
  paragraph("An explicit step: the forces at its beginning change the velocities, and these move the nodes.");
  formula_text("v_i^{n+1} = v_i^n + \\frac{\\Delta t}{m_i} ( f_i^{int} + f_i^{ext} )");
  if (!w.node) return;
  bold(node_name(context, w.d));
  property("Internal force", vector_text(entry(w.record.internal_start, *w.node, w.d), w.d, "N"));
  property("External force", vector_text(entry(w.record.external_start, *w.node, w.d), w.d, "N"));
  property("Velocity before", vector_text(entry(w.record.node_velocity, *w.node, w.d), w.d, "m/s"));
  property("Velocity after", vector_text(entry(w.record.node_velocity_end, *w.node, w.d), w.d, "m/s"));
}

const char* velocity_formula(const std::string& transfer) {
  if (transfer == "pic" || transfer == "fmpm") return "v_p = \\sum_i v_i^{n+1} N_i(x_p)";
  if (transfer == "apic") return "B_p = \\sum_i N_i(x_p) v_i^{n+1} \\otimes (x_i - x_p)";
  return "v_p \\to v_p + \\sum_i (v_i^{n+1} - v_i^n) N_i(x_p)";
}

void ride(const AppContext& context, const Watched& w) {
  paragraph("The particles are carried by the bent grid, and the grid's gradient deforms them.");
  formula_text("x_p^{n+1} = \\sum_i \\hat{x}_i N_i(x_p^n)");
  formula_text("F_p^{n+1} = ( \\sum_i \\hat{x}_i \\otimes \\nabla N_i ) F_p^n");
  formula_text(velocity_formula(w.player.scene().transfer.type));
  const Scene& scene = w.player.scene();
  if (scene.transfer.type == "flip" && scene.transfer.flip_ratio < 1)
    muted("Blended: " + quantity(100 * scene.transfer.flip_ratio, "", 3) +
          " % of this (FLIP), the rest is the grid's velocity itself (PIC).");
  if (!w.particle) return;
  bold(particle_name(context));
  const Vec3 a = w.x(), b = entry(w.record.after.x, *w.particle, w.d);
  property("Was at", vector_text(a, w.d, "m", 4));
  property("Moved by", vector_text(b - a, w.d, "m"));
  property("Velocity before", vector_text(entry(w.record.before.v, *w.particle, w.d), w.d, "m/s"));
  property("Velocity after", vector_text(entry(w.record.after.v, *w.particle, w.d), w.d, "m/s"));
  matrix_table("F before", w.F(w.record.before.F), w.d, w.d, "");
  matrix_table("F after", w.F(w.record.after.F), w.d, w.d, "");
}

void snap(const AppContext& context, const Watched& w) {
  paragraph(
      "The grid has served: it is thrown away. The particles keep position, velocity and F, and the next step begins "
      "on "
      "a grid that is straight again, with new weights. That push-forward gives the program its name.");
  formula_text("\\phi^{n+1} = \\hat{\\phi} \\circ \\phi^n,   F^{n+1} = \\hat{F} F^n");
  if (!w.particle) return;
  bold(particle_name(context));
  const Vec3 x = entry(w.record.after.x, *w.particle, w.d);
  property("Is now at", vector_text(x, w.d, "m", 4));
  property("Volume ratio J", quantity(w.F(w.record.before.F).determinant(), "", 5) + " \xe2\x86\x92 " +
                                 quantity(w.F(w.record.after.F).determinant(), "", 5));
  if (!context.selected_node) return;
  // The state at hand is the one that the step led to: its weights are the next step's.
  const auto& looked = context.looked;
  if (!looked || looked->step != w.record.step || !looked->particle ||
      looked->particle->state.id != *context.selected_particle)
    return;
  double fresh = 0;
  for (const NodeWeight& n : looked->particle->nodes)
    if (n.node == *context.selected_node) fresh = n.w;
  property("Its weight at " + index_text(*context.selected_node, w.d),
           quantity(w.w, "", 3) + " \xe2\x86\x92 " + quantity(fresh, "", 3));
}

}  // namespace

void draw_phase_panel(AppContext& context) {
  if (!context.slow) return;
  const StepPlayer& player = *context.slow;
  const Watched w = watched(context);
  const Phase& phase = player.phase();
  muted("Step " + std::to_string(player.record().step) + ", " + std::to_string(player.phase_index() + 1) + " of " +
        std::to_string(player.phases().size()));
  ImGui::PushFont(bold_font());
  paragraph(phase.title);
  ImGui::PopFont();
  gap(0.3F);
  switch (phase.kind) {
    case PhaseKind::give:
      return give(context, w);
    case PhaseKind::guess:
      return guess(context, w);
    case PhaseKind::iterate:
      return iterate(context, w, phase);
    case PhaseKind::kick:
      return kick(context, w);
    case PhaseKind::extrapolate:
      return paragraph("The scheme balanced forces within the step; from there velocities are carried on to its end.");
    case PhaseKind::ride:
      return ride(context, w);
    case PhaseKind::snap:
      return snap(context, w);
  }
}

}  // namespace pf::app
