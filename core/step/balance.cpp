#include "core/step/balance.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

namespace pf {

namespace {

template <int D>
Vec3 cross(const Vec<D>& a, const Vec<D>& b) {
  if constexpr (D == 2)
    return {0, 0, a[0] * b[1] - a[1] * b[0]};
  else
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The rotation in C D: sum_i m N_i r x (C r), r = x_i - x_p.
template <int D>
Vec3 affine_angular(const Mat<D>& C, const Vec<D>& inertia) {
  if constexpr (D == 2)
    return {0, 0, C(1, 0) * inertia[0] - C(0, 1) * inertia[1]};
  else
    return {C(2, 1) * inertia[1] - C(1, 2) * inertia[2], C(0, 2) * inertia[2] - C(2, 0) * inertia[0],
            C(1, 0) * inertia[0] - C(0, 1) * inertia[1]};
}

}  // namespace

namespace {

/// Of the particles of one block.
template <int D>
Balance block_balance(const Particles<D>& particles, const Laws<D>& laws, const Plan<D>& plan, const Block<D>& block,
                      bool affine, const Vec<D>& gravity) {
  Balance b;
  double psi[longest_run];
  for (int r = block.run_begin; r < block.run_end; ++r) {
    const MaterialRun& run = plan.runs()[static_cast<std::size_t>(r)];
    const auto n = static_cast<std::size_t>(run.end - run.begin);
    laws[run.material]->energy({particles.F.data() + run.begin, n}, {psi, n});
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t p = static_cast<std::size_t>(run.begin) + k;
      const double m = particles.mass[p];
      b.elastic += particles.volume0[p] * psi[k];
      b.kinetic += 0.5 * m * particles.v[p].squaredNorm();
      b.potential -= m * gravity.dot(particles.x[p]);
      b.momentum.head<D>() += m * particles.v[p];
      b.angular_momentum += m * cross<D>(particles.x[p], particles.v[p]);
      if (!affine) continue;
      const Vec<D> inertia = affine_inertia<D>(plan.basis(), plan.spacing(), particles.x[p]);
      const Mat<D>& C = particles.C[p];
      b.kinetic += 0.5 * m * (C.cwiseAbs2() * inertia).sum();
      b.angular_momentum += m * affine_angular<D>(C, inertia);
    }
  }
  return b;
}

}  // namespace

template <int D>
Balance particle_balance(const Particles<D>& particles, const Laws<D>& laws, const Plan<D>& plan, bool affine,
                         const Vec<D>& gravity, Parallel& parallel) {
  constexpr std::size_t together = 256;
  std::array<Balance, together> parts;
  Balance sum;
  for (std::size_t first = 0; first < plan.blocks().size(); first += together) {
    const std::size_t count = std::min(together, plan.blocks().size() - first);
    parallel(static_cast<int>(count), [&](int k) {
      const auto i = static_cast<std::size_t>(k);
      parts[i] = block_balance(particles, laws, plan, plan.blocks()[first + i], affine, gravity);
    });
    for (std::size_t i = 0; i < count; ++i) {
      sum.kinetic += parts[i].kinetic;
      sum.elastic += parts[i].elastic;
      sum.potential += parts[i].potential;
      sum.momentum += parts[i].momentum;
      sum.angular_momentum += parts[i].angular_momentum;
    }
  }
  return sum;
}

template <int D>
Vec3 grid_angular_momentum(const Plan<D>& plan, const Vector& u, double part, const Vector& momentum) {
  Vec3 L = Vec3::Zero();
  for (int i = 0; i < plan.node_count(); ++i)
    L += cross<D>(Vec<D>(plan.node_position(i) + part * u.segment<D>(i * D)), Vec<D>(momentum.segment<D>(i * D)));
  return L;
}

template <int D>
StateCheck check_state(const Particles<D>& particles, const Motion<D>& moved) {
  StateCheck check;
  check.min_J = INFINITY;
  check.max_J = -INFINITY;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const double J = moved.F[p].determinant(), speed = moved.v[p].norm();
    if (!std::isfinite(J) || !std::isfinite(speed) || !moved.x[p].allFinite()) {
      check.finite = false;
      check.worst = particles.id[p];
      return check;
    }
    if (J < check.min_J) check.worst = particles.id[p];
    check.min_J = std::min(check.min_J, J);
    check.max_J = std::max(check.max_J, J);
    check.max_speed = std::max(check.max_speed, speed);
  }
  return check;
}

#define PF_INSTANTIATE(D)                                                                                        \
  template Balance particle_balance<D>(const Particles<D>&, const Laws<D>&, const Plan<D>&, bool, const Vec<D>&, \
                                       Parallel&);                                                               \
  template Vec3 grid_angular_momentum<D>(const Plan<D>&, const Vector&, double, const Vector&);                  \
  template StateCheck check_state<D>(const Particles<D>&, const Motion<D>&);
PF_INSTANTIATE(2)
PF_INSTANTIATE(3)
#undef PF_INSTANTIATE

}  // namespace pf
