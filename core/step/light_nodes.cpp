// Nodes that hold next to nothing of the body: what is done about them, and what is said.
#include "core/step/simulation_of.hpp"
#include "core/transfers/transfer.hpp"

namespace pf {

namespace {

std::string number(double v) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.4g", v);
  return text.data();
}

}  // namespace

/// Without inertia it is the stiffness of a node, k_i = sum_p V_p^0 2 mu_p N_i / dx^2 [N/m], that says how light it is.
/// Of the two moduli the one for shear: the other grows without bound towards Poisson's ratio 1/2, and would hold the
/// edge.
template <int D>
bool SimulationOf<D>::tie_light_nodes(const StepChoice& choice) {
  const double gamma = scene_.integrator.ghost_penalty;
  if (gamma == 0 || has_inertia(choice)) return false;
  const std::size_t n = particles_.size();
  std::vector<Vec<D>> stiffness(n, Vec<D>::Zero());
  for (std::size_t p = 0; p < n; ++p) {
    const double mu = laws_[particles_.material[p]]->shear_modulus();
    stiffness[p][0] = particles_.volume0[p] * 2 * mu / (plan_.spacing() * plan_.spacing());
  }
  Vector sum = Vector::Zero(static_cast<Eigen::Index>(plan_.node_count()) * D);
  scatter_field<D>(plan_, stiffness, parallel_, sum);
  Vector k(plan_.node_count());
  for (Eigen::Index i = 0; i < k.size(); ++i) k[i] = sum[i * D];
  light_nodes_.clear();
  light_nodes_.build(plan_, k, gamma);
  return light_nodes_.lines() > 0;
}

template <int D>
void SimulationOf<D>::tell_of_blend(const MassMatrix<D>& M, StepReport& report) {
  if (M.blend() > 0 && !told_of_blend_)
    report.warnings.push_back("The consistent mass matrix is singular (" + std::to_string(particles_.size()) +
                              " particles, " + std::to_string(plan_.node_count()) + " nodes): blended with " +
                              number(100 * M.blend()) + " % of the lumped one. More particles a cell avoid this.");
  told_of_blend_ = M.blend() > 0;
}

template <int D>
void SimulationOf<D>::tell_of_plan(StepReport& report) {
  if (plan_.shrunk_domains() > 0 && !told_of_domains_)
    report.warnings.push_back(std::to_string(plan_.shrunk_domains()) +
                              " particles' domains have become larger than a cell: they are averaged over the part "
                              "within half a cell of their centre. More particles a cell avoid this.");
  if (plan_.edges_left() && !told_of_edges_)
    report.warnings.push_back(
        "Particles are more than half a cell behind a wall: there is no boundary correction on its axis until they are "
        "back.");
  told_of_domains_ = plan_.shrunk_domains() > 0;
  told_of_edges_ = plan_.edges_left();
}

#define PF_INSTANTIATE(D)                                                          \
  template bool SimulationOf<D>::tie_light_nodes(const StepChoice&);               \
  template void SimulationOf<D>::tell_of_blend(const MassMatrix<D>&, StepReport&); \
  template void SimulationOf<D>::tell_of_plan(StepReport&);
PF_INSTANTIATE(2)
PF_INSTANTIATE(3)
#undef PF_INSTANTIATE

}  // namespace pf
