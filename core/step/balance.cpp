#include "core/step/balance.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/grid/records.hpp"

namespace pf {

namespace {

template <int D>
Vec3 cross(const Vec<D>& a, const Vec<D>& b) {
  if constexpr (D == 2)
    return {0, 0, a[0] * b[1] - a[1] * b[0]};
  else
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Sums of one block's particles, a lane each until the end.
template <int D>
class LaneBalance {
 public:
  using Lane = Wide<lane_count<D>>;

  LaneBalance(const Particles<D>& particles, const Plan<D>& plan, bool affine, const Vec<D>& gravity)
      : particles_(particles), plan_(plan), affine_(affine), gravity_(gravity) {}

  /// `count` particles from p on; psi of the first, or null; D_p of the first, or null where it is the basis' own.
  void add(std::size_t p, int count, const double* psi, const Mat<D>* second) {
    const auto m = load_lane<Lane>(particles_.mass.data() + p, count);
    Lane x[D], v[D], mv[D], square{}, height{};
    load_lanes<D>(particles_.x[p].data(), count, x);
    load_lanes<D>(particles_.v[p].data(), count, v);
    for (int a = 0; a < D; ++a) {
      mv[a] = m * v[a];
      square += mv[a] * v[a];
      height += gravity_[a] * x[a];
      momentum_[a] += mv[a];
    }
    if (psi) elastic_ += load_lane<Lane>(particles_.volume0.data() + p, count) * load_lane<Lane>(psi, count);
    potential_ -= m * height;
    for (std::size_t k = 0; k < turns; ++k) {
      const auto [a, b] = axes(k);
      angular_[k] += x[a] * mv[b] - x[b] * mv[a];
    }
    if (affine_) {
      if (second) return add_affine(p, count, m, square, second);
      Lane C[D * D], inertia[D];
      load_lanes<D * D>(particles_.C[p].data(), count, C);
      affine_inertias(p, count, inertia);
      for (int b = 0; b < D; ++b) {
        const Lane mD = m * inertia[b];
        for (int a = 0; a < D; ++a) {
          square += mD * C[a + D * b] * C[a + D * b];
          C[a + D * b] *= mD;
        }
      }
      // sum_i m N_i r x (C r), r = x_i - x_p.
      for (std::size_t k = 0; k < turns; ++k) {
        const auto [a, b] = axes(k);
        angular_[k] += C[b + D * a] - C[a + D * b];
      }
    }
    kinetic_ += 0.5 * square;
  }
  Balance sum() const {
    Balance b;
    b.kinetic = sum_lanes(kinetic_);
    b.elastic = sum_lanes(elastic_);
    b.potential = sum_lanes(potential_);
    for (int a = 0; a < D; ++a) b.momentum[a] = sum_lanes(momentum_[a]);
    for (std::size_t k = 0; k < turns; ++k)
      b.angular_momentum[D == 2 ? 2 : static_cast<int>(k)] = sum_lanes(angular_[k]);
    return b;
  }

 private:
  /// D_p is a full matrix.
  void add_affine(std::size_t p, int count, const Lane& m, Lane square, const Mat<D>* second) {
    Lane C[D * D], S[D * D], B[D * D];
    load_lanes<D * D>(particles_.C[p].data(), count, C);
    load_lanes<D * D>(second->data(), count, S);
    multiply_lanes<D>(C, S, B);
    for (int k = 0; k < D * D; ++k) square += m * B[k] * C[k];
    for (std::size_t k = 0; k < turns; ++k) {
      const auto [a, b] = axes(k);
      angular_[k] += m * (B[b + D * a] - B[a + D * b]);
    }
    kinetic_ += 0.5 * square;
  }
  static constexpr std::size_t turns = D == 2 ? 1 : 3;
  /// The axes a, b of the plane that component k turns in, from a to b.
  static constexpr std::pair<int, int> axes(std::size_t k) {
    const int first = D == 2 ? 0 : static_cast<int>(k + 1) % 3;
    return {first, D == 2 ? 1 : (first + 1) % 3};
  }
  void affine_inertias(std::size_t p, int count, Lane* inertia) const {
    const BasisInfo& basis = plan_.basis();
    if (basis.affine_by_moments) {
      std::fill_n(inertia, D, Lane{} + basis.moment * plan_.spacing() * plan_.spacing());
      return;
    }
    std::fill_n(inertia, D, Lane{});
    for (int lane = 0; lane < count; ++lane) {
      const Vec<D> one = affine_inertia<D>(basis, plan_.spacing(), particles_.x[p + static_cast<std::size_t>(lane)]);
      for (int a = 0; a < D; ++a) inertia[a][lane] = one[a];
    }
  }

  const Particles<D>& particles_;
  const Plan<D>& plan_;
  bool affine_;
  const Vec<D>& gravity_;
  Lane kinetic_{}, elastic_{}, potential_{}, momentum_[D] = {}, angular_[turns] = {};
};

template <int D>
Balance block_balance(const Particles<D>& particles, const Laws<D>& laws, const Plan<D>& plan, const Block<D>& block,
                      bool affine, const Vec<D>& gravity, bool elastic) {
  LaneBalance<D> balance(particles, plan, affine, gravity);
  double psi[longest_run];
  const bool own = affine && !plan.regular();
  std::vector<Mat<D>> second(own ? static_cast<std::size_t>(block.particle_end - block.particle_begin) : 0);
  if (own) affine_inertias(plan, particles, block, second.data());
  for (int r = block.run_begin; r < block.run_end; ++r) {
    const MaterialRun& run = plan.runs()[static_cast<std::size_t>(r)];
    const int n = run.end - run.begin;
    const auto begin = static_cast<std::size_t>(run.begin);
    if (elastic)
      laws[run.material]->energy({particles.F.data() + begin, static_cast<std::size_t>(n)},
                                 {psi, static_cast<std::size_t>(n)});
    for (int k = 0; k < n; k += lane_count<D>)
      balance.add(begin + static_cast<std::size_t>(k), std::min(lane_count<D>, n - k), elastic ? psi + k : nullptr,
                  own ? second.data() + (run.begin + k - block.particle_begin) : nullptr);
  }
  return balance.sum();
}

}  // namespace

template <int D>
Balance particle_balance(const Particles<D>& particles, const Laws<D>& laws, const Plan<D>& plan, bool affine,
                         const Vec<D>& gravity, Parallel& parallel, const double* elastic) {
  constexpr std::size_t together = 256;
  std::array<Balance, together> parts;
  Balance sum;
  for (std::size_t first = 0; first < plan.blocks().size(); first += together) {
    const std::size_t count = std::min(together, plan.blocks().size() - first);
    parallel(static_cast<int>(count), [&](int k) {
      const auto i = static_cast<std::size_t>(k);
      parts[i] = block_balance(particles, laws, plan, plan.blocks()[first + i], affine, gravity, !elastic);
    });
    for (std::size_t i = 0; i < count; ++i) {
      sum.kinetic += parts[i].kinetic;
      sum.elastic += parts[i].elastic;
      sum.potential += parts[i].potential;
      sum.momentum += parts[i].momentum;
      sum.angular_momentum += parts[i].angular_momentum;
    }
  }
  if (elastic) sum.elastic = *elastic;
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
StateCheck check_state(const Particles<D>& particles) {
  StateCheck check{.min_J = INFINITY, .max_J = -INFINITY};
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const double J = particles.F[p].determinant(), speed = particles.v[p].norm();
    const bool finite = std::isfinite(J) && std::isfinite(speed) && particles.x[p].allFinite();
    check.include({finite, J, J, speed});
  }
  return check;
}

template <int D>
std::uint32_t worst_particle(const Particles<D>& particles, const Motion<D>& moved) {
  double least = INFINITY;
  std::size_t worst = 0;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const std::size_t to = moved.place ? moved.place[p] : p;
    const double J = moved.F[to].determinant();
    if (!std::isfinite(J) || !moved.v[to].allFinite() || !moved.x[p].allFinite()) return particles.id[p];
    if (J < least) worst = p;
    least = std::min(least, J);
  }
  return particles.id[worst];
}

#define PF_INSTANTIATE(D)                                                                                        \
  template Balance particle_balance<D>(const Particles<D>&, const Laws<D>&, const Plan<D>&, bool, const Vec<D>&, \
                                       Parallel&, const double*);                                                \
  template Vec3 grid_angular_momentum<D>(const Plan<D>&, const Vector&, double, const Vector&);                  \
  template StateCheck check_state<D>(const Particles<D>&);                                                       \
  template std::uint32_t worst_particle<D>(const Particles<D>&, const Motion<D>&);
PF_INSTANTIATE(2)
PF_INSTANTIATE(3)
#undef PF_INSTANTIATE

}  // namespace pf
