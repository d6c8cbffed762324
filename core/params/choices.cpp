#include "core/params/choices.hpp"

namespace pf {
namespace {

constexpr Choice basis_table[] = {
    {"linear", "Linear (Q1)", "cheapest; the force jumps when a particle crosses a cell face"},
    {"quadratic", "Quadratic B-spline", "the usual choice: smooth gradients, 3 nodes a direction"},
    {"cubic", "Cubic B-spline", "smoothest, 4 nodes a direction; wider contact gap"},
};
constexpr Choice integrator_table[] = {
    {"backward_euler", "Backward Euler", "implicit and stable at any step; damps oscillation as the step grows"},
    {"symplectic_euler", "Symplectic Euler", "explicit: no solve, but unstable beyond the sound-speed limit"},
};
constexpr Choice transfer_table[] = {
    {"pic", "PIC", "robust and very dissipative; loses angular momentum"},
    {"flip", "FLIP", "keeps energy; flip_ratio below 1 blends in PIC against noise"},
    {"apic", "APIC", "keeps angular momentum in the transfer with little noise"},
};
constexpr Choice solver_table[] = {
    {"auto", "Automatic", "chosen by counted work from the size of the scene"},
    {"pcg_jacobi", "CG, block-Jacobi", "matrix-free conjugate gradients: large scenes, little memory"},
    {"direct", "Direct Cholesky", "sparse factorisation: small or stiff 2D scenes"},
};
constexpr Choice mass_table[] = {
    {"lumped", "Lumped", "row sums: diagonal, positive wherever there is mass"},
    {"consistent", "Consistent", "the full matrix: more accurate, may be nearly singular at edges"},
};
constexpr Choice sampling_table[] = {
    {"lattice", "Lattice", "regular, aligned with the grid: most accurate at the start"},
    {"jittered", "Jittered", "lattice points moved at random (seed): no preferred direction"},
    {"poisson_disc", "Poisson disc", "random with a least distance (seed): even and irregular"},
};
constexpr Choice contact_table[] = {
    {"stick", "Stick", "material that touches moves with the boundary"},
    {"slip", "Slip", "slides along the boundary, never leaves it"},
    {"separate", "Separate", "may leave the boundary, never enters it"},
};
constexpr Choice control_table[] = {
    {"fixed", "Fixed step", "every step as long as time.step"},
};
constexpr Choice shape_table[] = {
    {"box", "Box", "between two corners"},
    {"ball", "Ball", "a disc in 2D"},
    {"cylinder", "Cylinder", "round, between the centres of its two ends; 3D"},
    {"polygon", "Polygon", "closed by itself, must not cross itself; 2D"},
    {"half_space", "Half space", "everything behind a plane (3D) or a line (2D); normal points out of it"},
    {"where", "Where", "all points between two corners where an expression in X Y Z is positive"},
    {"union", "Union", "what is in any of several shapes"},
    {"difference", "Difference", "the first shape without the others"},
    {"intersection", "Intersection", "what is in all of several shapes"},
};

}  // namespace

std::span<const Choice> bases() {
  return basis_table;
}
std::span<const Choice> integrators() {
  return integrator_table;
}
std::span<const Choice> transfers() {
  return transfer_table;
}
std::span<const Choice> linear_solvers() {
  return solver_table;
}
std::span<const Choice> masses() {
  return mass_table;
}
std::span<const Choice> samplings() {
  return sampling_table;
}
std::span<const Choice> contacts() {
  return contact_table;
}
std::span<const Choice> step_controls() {
  return control_table;
}
std::span<const Choice> shapes() {
  return shape_table;
}

const Choice* find_choice(std::span<const Choice> choices, std::string_view name) {
  for (const Choice& choice : choices) {
    if (choice.name == name) return &choice;
  }
  return nullptr;
}

std::vector<std::string> names(std::span<const Choice> choices) {
  std::vector<std::string> result;
  for (const Choice& choice : choices) result.emplace_back(choice.name);
  return result;
}

}  // namespace pf
