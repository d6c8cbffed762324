// What the tests of the numerics share: particles in unfriendly places, the parts of a step around them, and the shape
// functions written out as in THEORY T2.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "core/energies/elastic.hpp"
#include "core/grid/mass.hpp"
#include "core/grid/stencil.hpp"
#include "core/transfers/transfer.hpp"
#include "tests/materials/cases.hpp"

namespace pf::test {

/// Uniform in [low, high], the same numbers everywhere.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967295.0;
  }
  template <int D>
  Vec<D> vector(double size) {
    return Vec<D>::NullaryExpr([&] { return (*this)(-size, size); });
  }
  template <int D>
  Mat<D> matrix(double size) {
    return Mat<D>::NullaryExpr([&] { return (*this)(-size, size); });
  }
  Vector values(Eigen::Index n, double size) {
    return Vector::NullaryExpr(n, [&] { return (*this)(-size, size); });
  }

 private:
  std::mt19937 engine_;
};

template <int D>
void add_particle(Particles<D>& to, const Vec<D>& x, double mass, double volume, std::uint16_t material = 0) {
  to.X.push_back(x);
  to.x.push_back(x);
  to.v.push_back(Vec<D>::Zero());
  to.F.push_back(Mat<D>::Identity());
  to.C.push_back(Mat<D>::Zero());
  to.mass.push_back(mass);
  to.volume0.push_back(volume);
  to.id.push_back(static_cast<std::uint32_t>(to.id.size()));
  to.body.push_back(0);
  to.material.push_back(material);
}

/// `count` particles scattered over [-size, size]^D, around the origin so that coordinates of both signs occur; some
/// exactly on nodes, faces and cell centres. Velocities, F and C are random, det F > 0.
template <int D>
Particles<D> scattered(int count, double spacing, double size, unsigned seed, int materials = 1) {
  Random random(seed);
  Particles<D> particles;
  for (int p = 0; p < count; ++p) {
    Vec<D> x = random.vector<D>(size);
    if (p % 4 == 1) x = ((x / spacing).array().round() * spacing).matrix();
    if (p % 4 == 2) x = (((x / spacing).array().floor() + 0.5) * spacing).matrix();
    if (p % 4 == 3) x[0] = std::round(x[0] / spacing) * spacing;
    const double volume = random(0.1, 1) * std::pow(spacing, D);
    add_particle<D>(particles, x, 1000 * volume, volume, static_cast<std::uint16_t>(p % materials));
    particles.v.back() = random.vector<D>(2);
    particles.F.back() = Mat<D>::Identity() + random.matrix<D>(0.2);
    particles.C.back() = random.matrix<D>(5);
  }
  return particles;
}

/// N of the B-splines at r = (x - x_i)/dx, not averaged: the formulas of THEORY T2, independent of core/bases.
inline double spline(std::string_view basis, double r) {
  r = std::abs(r);
  if (basis == "linear" || basis == "gimp") return r < 1 ? 1 - r : 0;
  if (basis == "quadratic" || basis == "quadratic_gimp")
    return r < 0.5 ? 0.75 - r * r : r < 1.5 ? 0.5 * (1.5 - r) * (1.5 - r) : 0;
  return r < 1 ? 2.0 / 3 - r * r + r * r * r / 2 : r < 2 ? (2 - r) * (2 - r) * (2 - r) / 6 : 0;
}

/// N_i(x) of a node of the lattice.
template <int D>
double shape(std::string_view basis, double spacing, const Vec<D>& node, const Vec<D>& x) {
  double N = 1;
  for (int a = 0; a < D; ++a) N *= spline(basis, (x[a] - node[a]) / spacing);
  return N;
}

/// The bases whose weights are the splines' own at the particle.
inline std::vector<BasisInfo> sampled_bases() {
  std::vector<BasisInfo> list;
  for (const BasisInfo& basis : bases())
    if (!basis.averaged()) list.push_back(basis);
  return list;
}

/// Calls f(particle, node, weight, gradient) for every pair that the plan couples.
template <int D, class F>
void for_each_pair(const Plan<D>& plan, F&& f) {
  for (const Block<D>& block : plan.blocks())
    for (int i = block.batch_begin; i < block.batch_end; ++i) {
      const Batch& batch = plan.batches()[static_cast<std::size_t>(i)];
      Wide<lane_count<D>> room[2 * D * max_nodes_per_axis];
      const Wide<lane_count<D>>* const w = plan.weights(i, room);
      with_nodes_per_axis(plan, [&](auto k) {
        constexpr int K = k;
        for (int n = 0; n < (D == 2 ? K * K : K * K * K); ++n) {
          const int node = plan.node_table(block)[batch.node + node_offset<D, K>(n)];
          if (node < 0 && decltype(k)::dense) continue;  // no domain of this batch reaches it
          Wide<lane_count<D>> gradient[D];
          node_gradient<D, K, decltype(k)::dense>(w, n, gradient);
          const Wide<lane_count<D>> N = node_value<D, K, decltype(k)::dense>(w, n);
          for (int lane = 0; lane < batch.count; ++lane) {
            Vec<D> grad;
            for (int a = 0; a < D; ++a) grad[a] = gradient[a][lane];
            f(static_cast<std::size_t>(batch.first + lane), node, N[lane], grad);
          }
        }
      });
    }
}

/// Particles, their plan, laws and mass: what a step works with.
template <int D>
struct Grid {
  Grid(Particles<D> with, std::string_view basis, double dx, int threads = 1)
      : particles(std::move(with)), spacing(dx), parallel(threads) {
    planned = plan.build(particles, *find_basis(basis), spacing, parallel);
    if (planned) particles_to_grid(plan, particles, false, parallel, state);
  }
  Grid(const Grid&) = delete;

  /// One law for each material index, with its typical parameters.
  void use_law(const LawInfo& info) { laws.push_back(make_law<D>(info.name, typical_parameters(info))); }
  Eigen::Index unknowns() const { return plan.node_count() * D; }

  Particles<D> particles;
  double spacing;
  Parallel parallel;
  Plan<D> plan;
  bool planned = false;
  Laws<D> laws;
  Work work;
  GridState<D> state;
};

}  // namespace pf::test
