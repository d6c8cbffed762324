#include "core/bench/body.hpp"

#include <array>
#include <cmath>

namespace pf::bench {

namespace {

constexpr double density = 1000, young = 1e5, poisson = 0.3;

/// A number in [-1, 1] that depends on k only.
double scattered(std::uint64_t k) {
  k = (k ^ (k >> 31)) * 0x7fb5d329728ea185ull;
  k = (k ^ (k >> 27)) * 0x81dadef4bc2dd44dull;
  return static_cast<double>((k ^ (k >> 33)) >> 11) * 0x1p-52 - 1;
}

}  // namespace

template <int D>
Body<D>::Body(std::string_view basis_name, std::size_t about_particles, int threads)
    : parallel(threads), basis(*find_basis(basis_name)) {
  const int a_cell = D == 2 ? 4 : 8;
  const int edge =
      std::max(2, static_cast<int>(std::round(std::pow(static_cast<double>(about_particles) / a_cell, 1.0 / D))));
  const double step = spacing / 2, volume = std::pow(step, D);
  const int points = 2 * edge;
  for (int k = 0; k < (D == 3 ? points : 1); ++k)
    for (int j = 0; j < points; ++j)
      for (int i = 0; i < points; ++i) {
        Vec<D> X;
        X[0] = (i + 0.5) * step;
        X[1] = (j + 0.5) * step;
        if constexpr (D == 3) X[2] = (k + 0.5) * step;
        const std::uint64_t id = particles.id.size();
        Mat<D> F = Mat<D>::Identity();
        for (int a = 0; a < D * D; ++a) F(a) += 0.05 * scattered(100 * id + static_cast<std::uint64_t>(a));
        Vec<D> x = X, v;
        for (int a = 0; a < D; ++a) {
          x[a] += 0.1 * step * scattered(100 * id + 20 + static_cast<std::uint64_t>(a));
          v[a] = std::sin(5 * X[a]);
        }
        particles.X.push_back(X);
        particles.x.push_back(x);
        particles.v.push_back(v);
        particles.F.push_back(F);
        particles.C.push_back(Mat<D>::Constant(0.5));
        particles.mass.push_back(density * volume);
        particles.volume0.push_back(volume);
        particles.id.push_back(static_cast<std::uint32_t>(id));
        particles.body.push_back(0);
        particles.material.push_back(0);
      }
  laws.push_back(make_law<D>("neo_hookean", std::array{young, poisson}));
  build_plan();
  particles_to_grid(plan, particles, true, parallel, grid);
  lumped_velocity(plan, particles, grid);
  grid.u = displacements();
  grid.v_end = grid.v;
}

template <int D>
void Body<D>::shake() {
  const double way = shaken++ % 2 == 0 ? 0.5 * spacing : -0.5 * spacing;
  for (std::size_t p = 0; p < particles.size(); ++p)
    for (int a = 0; a < D; ++a) particles.x[p][a] += way * scattered(7 * particles.id[p] + static_cast<unsigned>(a));
}

template <int D>
void Body<D>::build_plan() {
  plan.build(particles, basis, spacing, parallel);
}

template <int D>
Vector Body<D>::displacements() const {
  Vector u(plan.node_count() * D);
  for (int i = 0; i < plan.node_count(); ++i) {
    const Vec<D> x = plan.node_position(i);
    for (int a = 0; a < D; ++a) u[i * D + a] = 0.01 * std::sin(5 * x[a] + 3 * x[(a + 1) % D]);
  }
  return u;
}

template struct Body<2>;
template struct Body<3>;

}  // namespace pf::bench
