#include "app/widgets/choices.hpp"

#include <algorithm>
#include <array>

#include "core/materials/law.hpp"

namespace pf::app {

namespace {

/// A word of the scene file. Of a method, what shows that it is worth choosing: a study on whose front it stands, or a
/// lesson that uses what it does; `nowhere` where nothing does (yet). Other words are always offered.
struct Choice {
  std::string_view pointer_end, word, label, help, shown_by;
};
constexpr std::string_view nowhere = "-";
constexpr std::array table{
    Choice{"/integrator/type", "backward_euler", "Backward Euler (implicit)",
           "Stable at any step. Damps fast vibrations, the more the longer the step.",
           "cheapest at long steps (study explicit-or-implicit)"},
    Choice{"/integrator/type", "symplectic_euler", "Symplectic Euler (explicit)",
           "Cheap steps and no damping, but unstable above the explicit limit.",
           "cheapest at short steps (studies bar-integrators, explicit-or-implicit)"},
    Choice{"/integrator/type", "implicit_midpoint", "Implicit midpoint",
           "Second order in the step. Keeps the energy of small motions; may gain some in hard contact.",
           "on the front of study bar-integrators"},
    Choice{"/integrator/type", "trapezoidal", "Trapezoidal rule", "Second order in the step, no damping.", nowhere},
    Choice{"/integrator/type", "tr_bdf2", "TR-BDF2", "Second order, damps only what the step cannot follow.",
           "on the front of study bar-integrators"},
    Choice{"/integrator/type", "generalized_alpha", "Generalised alpha", "Second order with damping that can be set.",
           "on the front of study bar-integrators"},
    Choice{"/integrator/type", "quasi_static", "Quasi-static (no inertia)", "Equilibrium at every load.",
           "lesson Locking"},
    Choice{"/integrator/mass", "lumped", "Lumped", "All mass at the nodes: a diagonal matrix, robust and cheap.",
           "on the front of study mass-matrices"},
    Choice{"/integrator/mass", "consistent", "Consistent",
           "The mass matrix of the shape functions: couples neighbours.", "on the front of study mass-matrices"},
    Choice{"/velocity_mass", "lumped", "Lumped", "Nodes average the particles around them.",
           "on the front of study mass-matrices"},
    Choice{"/velocity_mass", "consistent", "Consistent",
           "Nodes take the velocities that give the particles' own back: PIC without its smoothing, but noise stays.",
           "lesson Lumped or consistent mass"},
    Choice{"/transfer/type", "pic", "PIC (averages)", "Very stable, damps motion and spin strongly.",
           "lesson PIC, FLIP, APIC"},
    Choice{"/transfer/type", "flip", "FLIP (increments)", "Keeps motion and spin, may keep noise.",
           "on the front of study mass-matrices"},
    Choice{"/transfer/type", "apic", "APIC (affine)", "Keeps linear and angular momentum exactly in the transfer.",
           "least noise for what it keeps (study transfers-disc)"},
    Choice{"/transfer/type", "fmpm", "FMPM (filtered)", "PIC with its smoothing taken back, order by order.",
           "on the front of study free-edges"},
    Choice{"/solver/linear", "auto", "Automatic", "Chosen by counted work; the choice is shown below.", {}},
    Choice{"/solver/linear", "pcg_jacobi", "Conjugate gradients, block-Jacobi",
           "Few bytes and no factorisation; many iterations on stiff scenes.",
           "cheapest on small scenes (study linear-solvers)"},
    Choice{"/solver/linear", "pcg_ic", "Conjugate gradients, incomplete Cholesky", "Fewer, dearer iterations.",
           nowhere},
    Choice{"/solver/linear", "pcg_multigrid", "Conjugate gradients, multigrid", "For large or stiff scenes.",
           "cheapest from two thousand particles on (study linear-solvers)"},
    Choice{"/solver/linear", "direct", "Direct (sparse Cholesky)", "Exact; for small 2D scenes.", nowhere},
    Choice{"/grid/basis", "linear", "Linear", "Cheapest. Forces jump when a particle crosses a cell face.",
           "lesson Shape functions; cheapest on coarse grids (study bases)"},
    Choice{"/grid/basis", "quadratic", "Quadratic B-spline", "Smooth forces; the usual choice.",
           "on the front of study bases"},
    Choice{"/grid/basis", "cubic", "Cubic B-spline", "Smoother still, with a wider reach and more work.",
           "lesson Shape functions"},
    Choice{"/grid/basis", "gimp", "Linear, averaged (GIMP)",
           "Linear functions averaged over each particle's own domain.", "on the front of study averaged-bases"},
    Choice{"/grid/basis", "quadratic_gimp", "Quadratic, averaged",
           "Quadratic B-splines averaged over each particle's own domain: the most exact once particles have moved.",
           "on the front of study averaged-bases"},
    Choice{"/contact", "stick", "Stick", "The material moves with the wall.", {}},
    Choice{"/contact", "slip", "Slip", "It slides along the wall and never leaves it.", {}},
    Choice{"/contact", "separate", "Separate", "It slides, rubs where there is friction, and may lift off.", {}},
    Choice{"/sampling", "lattice", "Lattice", "Particles in regular rows, aligned with the grid.", {}},
    Choice{"/sampling", "fitted", "Fitted to the surface",
           "Rows, cut by the body's surface: the edge is no staircase, the particles there are smaller.",
           "on the front of study free-edges"},
    Choice{"/sampling", "jittered", "Jittered", "Rows shaken at random: no alignment with the grid.", {}},
    Choice{"/sampling", "poisson_disc", "Poisson discs", "Random with a least distance: irregular but even.", {}},
    Choice{"/time/control", "fixed", "Fixed step", "Every step is as long as the time step says.", {}},
    Choice{"/time/control", "adaptive", "Adaptive", "The step follows a tolerance on the error.", {}},
};

const Choice* find(std::string_view pointer, std::string_view word) {
  const auto it = std::find_if(table.begin(), table.end(),
                               [&](const Choice& c) { return pointer.ends_with(c.pointer_end) && word == c.word; });
  return it == table.end() ? nullptr : &*it;
}

const LawInfo* law_of(std::string_view pointer, std::string_view word) {
  return pointer.ends_with("/model") ? find_law(word) : nullptr;
}

}  // namespace

std::string choice_label(std::string_view pointer, std::string_view choice) {
  if (const LawInfo* law = law_of(pointer, choice)) return std::string(law->label);
  if (const Choice* c = find(pointer, choice)) return std::string(c->label);
  std::string label(choice);
  std::replace(label.begin(), label.end(), '_', ' ');
  if (!label.empty() && label.front() >= 'a' && label.front() <= 'z')
    label.front() = static_cast<char>(label.front() - 32);
  return label;
}

std::string choice_help(std::string_view pointer, std::string_view choice) {
  if (const LawInfo* law = law_of(pointer, choice)) return std::string(law->about);
  const Choice* c = find(pointer, choice);
  if (c == nullptr) return {};
  std::string text(c->help);
  if (c->shown_by == nowhere) return text + "\nNo study has it on its front: left to scene files and studies.";
  if (!c->shown_by.empty()) text += "\nWhy it is offered: " + std::string(c->shown_by) + ".";
  return text;
}

bool choice_offered(std::string_view pointer, std::string_view choice) {
  const Choice* c = find(pointer, choice);
  return c == nullptr || c->shown_by != nowhere;
}

}  // namespace pf::app
