// Shape functions averaged over particles' domains (core/grid/domain.hpp).
#include <doctest/doctest.h>

#include <Eigen/LU>
#include <map>

#include "core/math/svd.hpp"
#include "tests/numerics.hpp"

using namespace pf;
using test::Grid;

namespace {

constexpr double dx = 0.1;

std::vector<BasisInfo> averaged_bases() {
  std::vector<BasisInfo> list;
  for (const BasisInfo& basis : bases())
    if (basis.averaged()) list.push_back(basis);
  return list;
}
/// The spline that is averaged.
std::string_view spline_of(const BasisInfo& basis) {
  return basis.nodes_per_axis == 3 ? "linear" : "quadratic";
}

/// A rotation by `angle` in the first two axes, and in 3D by as much in the last two.
template <int D>
Mat<D> turned(double angle) {
  Mat<D> R = Mat<D>::Identity(), S = R;
  R(0, 0) = R(1, 1) = std::cos(angle);
  R(1, 0) = std::sin(angle);
  R(0, 1) = -R(1, 0);
  if (D == 2) return R;
  S(D - 1, D - 1) = S(D - 2, D - 2) = std::cos(angle);
  S(D - 1, D - 2) = std::sin(angle);
  S(D - 2, D - 1) = -S(D - 1, D - 2);
  return R * S;
}

/// The mean of N over the domain F l_0 about x by `points` midpoints along each edge.
template <int D>
double mean(std::string_view spline, const Vec<D>& node, const Vec<D>& x, const Mat<D>& F, double l_0, int points) {
  int total = 1;
  for (int a = 0; a < D; ++a) total *= points;
  double sum = 0;
  for (int q = 0; q < total; ++q) {
    Vec<D> s;
    for (int a = 0, rest = q; a < D; ++a, rest /= points) s[a] = (rest % points + 0.5) / points - 0.5;
    sum += test::shape<D>(spline, dx, node, Vec<D>(x + l_0 * (F * s)));
  }
  return sum / total;
}

/// Largest difference between the plan's weights of a particle and the mean over its domain.
template <int D>
double worst_weight(const BasisInfo& basis, const Mat<D>& F, int points) {
  test::Random random(3);
  Particles<D> particles;
  for (int p = 0; p < 6; ++p) {
    test::add_particle<D>(particles, random.vector<D>(0.3), 1, std::pow(dx / 2, D));
    particles.F.back() = F;
  }
  Grid<D> grid(particles, basis.name, dx);
  double worst = 0;
  test::for_each_pair(grid.plan, [&](std::size_t p, int node, double N, const Vec<D>&) {
    worst = std::max(worst, std::abs(N - mean<D>(spline_of(basis), grid.plan.node_position(node), grid.particles.x[p],
                                                 F, dx / 2, points)));
  });
  return worst;
}

/// Particles on a lattice dx/2 that F has deformed, moved by `offset`.
template <int D>
Particles<D> deformed_lattice(const Mat<D>& F, const Vec<D>& offset, int edge) {
  Particles<D> particles;
  int total = 1;
  for (int a = 0; a < D; ++a) total *= edge;
  for (int q = 0; q < total; ++q) {
    Vec<D> X;
    for (int a = 0, rest = q; a < D; ++a, rest /= edge) X[a] = (rest % edge + 0.5 - 0.5 * edge) * dx / 2;
    test::add_particle<D>(particles, Vec<D>(F * X + offset), 1, std::pow(dx / 2, D));
    particles.F.back() = F;
  }
  return particles;
}

/// Root mean square of sum_p V_p grad N_i over nodes that only see inner particles, over V/dx of a cell: the force that
/// a constant stress must not make.
template <int D>
double patch_force(std::string_view basis, const Mat<D>& F) {
  const int edge = D == 2 ? 24 : 14;
  const double within = D == 2 ? 3.0 : 1.2;  // cells from the centre
  double sum = 0;
  int count = 0;
  test::Random random(7);
  for (int trial = 0; trial < 5; ++trial) {
    Grid<D> grid(deformed_lattice<D>(F, random.vector<D>(dx), edge), basis, dx);
    std::vector<Vec<D>> force(static_cast<std::size_t>(grid.plan.node_count()), Vec<D>::Zero());
    test::for_each_pair(grid.plan, [&](std::size_t, int node, double, const Vec<D>& grad) {
      force[static_cast<std::size_t>(node)] += std::pow(dx / 2, D) * F.determinant() * grad;
    });
    for (int i = 0; i < grid.plan.node_count(); ++i)
      if ((F.inverse() * grid.plan.node_position(i)).cwiseAbs().maxCoeff() < within * dx) {
        sum += force[static_cast<std::size_t>(i)].squaredNorm() / D;
        ++count;
      }
  }
  REQUIRE(count > 20);
  return std::sqrt(sum / count) / std::pow(dx, D - 1);
}

template <int D>
void check_consistency(const BasisInfo& basis) {
  Grid<D> grid(test::scattered<D>(120, dx, 0.5, 31), basis.name, dx);
  const std::size_t n = grid.particles.size();
  std::vector<double> sum(n, 0);
  std::vector<Vec<D>> place(n, Vec<D>::Zero()), slope(n, Vec<D>::Zero());
  std::vector<Mat<D>> stretch(n, Mat<D>::Zero());
  std::map<std::pair<std::uint32_t, std::array<long long, D>>, std::pair<double, Vec<D>>> at;
  test::for_each_pair(grid.plan, [&](std::size_t p, int node, double N, const Vec<D>& grad) {
    const Vec<D> x_i = grid.plan.node_position(node);
    sum[p] += N;
    place[p] += N * x_i;
    slope[p] += grad;
    stretch[p] += x_i * grad.transpose();
    at[{grid.particles.id[p], grid.plan.node_index(node)}] = {N, grad};
  });
  for (std::size_t p = 0; p < n; ++p) {
    CHECK(std::abs(sum[p] - 1) < 1e-14);
    CHECK((place[p] - grid.particles.x[p]).norm() < 1e-14);
    CHECK(slope[p].norm() * dx < 1e-13);
    CHECK((stretch[p] - Mat<D>::Identity()).norm() < 1e-12);
  }
  // The gradient is the derivative with respect to the centre. Slopes of the mean of linear functions have kinks.
  constexpr double h = 1e-5 * dx;
  for (int a = 0; a < D; ++a) {
    Particles<D> moved = grid.particles;
    for (Vec<D>& x : moved.x) x[a] += h;
    Grid<D> ahead(moved, basis.name, dx);
    for (Vec<D>& x : moved.x) x[a] -= 2 * h;
    Grid<D> behind(moved, basis.name, dx);
    std::map<std::pair<std::uint32_t, std::array<long long, D>>, double> change;
    const auto add = [&](const Grid<D>& g, double sign) {
      test::for_each_pair(g.plan, [&](std::size_t p, int node, double N, const Vec<D>&) {
        change[{g.particles.id[p], g.plan.node_index(node)}] += sign * N / (2 * h);
      });
    };
    add(ahead, 1);
    add(behind, -1);
    double worst = 0;
    for (const auto& [key, value] : change) {
      const auto found = at.find(key);
      worst = std::max(worst, std::abs(value - (found == at.end() ? 0 : found->second.second[a])) * dx);
    }
    CHECK(worst < 1e-4);
  }
}

/// Far too long for its nodes: shrunk and told, never cut off.
template <int D>
void check_shrunk(const BasisInfo& basis) {
  Particles<D> particles;
  test::add_particle<D>(particles, Vec<D>::Constant(0.03), 1, std::pow(dx / 2, D));
  particles.F[0] = 5 * turned<D>(0.4);
  Grid<D> grid(particles, basis.name, dx);
  CHECK(grid.plan.shrunk_domains() == 1);
  double sum = 0;
  Vec<D> place = Vec<D>::Zero();
  test::for_each_pair(grid.plan, [&](std::size_t, int node, double N, const Vec<D>&) {
    sum += N;
    place += N * grid.plan.node_position(node);
  });
  CHECK(std::abs(sum - 1) < 1e-14);
  CHECK((place - particles.x[0]).norm() < 1e-14);
}

}  // namespace

TEST_CASE("domains along the axes are averaged exactly, others to the width of their pieces") {
  for (const BasisInfo& basis : averaged_bases()) {
    CAPTURE(basis.name);
    CHECK(worst_weight<2>(basis, Vec<2>(1.3, 0.6).asDiagonal(), 400) < 1e-5);
    CHECK(worst_weight<3>(basis, Vec<3>(1.3, 0.6, 1.8).asDiagonal(), 60) < 4e-4);
    CHECK(worst_weight<2>(basis, turned<2>(std::acos(0.0)), 400) < 1e-5);
    Mat<2> sheared = turned<2>(0.5);
    sheared(0, 1) += 0.4;
    CHECK(worst_weight<2>(basis, sheared, 400) < 1.5e-3);
    CHECK(worst_weight<3>(basis, turned<3>(0.6), 60) < 4e-3);
  }
}

TEST_CASE("averaged weights add up, reproduce linear fields and have their derivatives as gradients") {
  for (const BasisInfo& basis : averaged_bases()) {
    CAPTURE(basis.name);
    check_consistency<2>(basis);
    check_consistency<3>(basis);
  }
}

TEST_CASE("domains that tile a deformed body leave no force under constant stress, where samples leave one") {
  Mat<2> sheared = turned<2>(0.5) * 1.1;
  sheared(0, 1) += 0.3;
  const Mat<2> stretched = Vec<2>(1.37, 0.9).asDiagonal();
  CHECK(patch_force<2>("quadratic", stretched) > 0.02);
  CHECK(patch_force<2>("quadratic_gimp", stretched) < 1e-13);
  CHECK(patch_force<2>("gimp", stretched) < 1e-13);
  MESSAGE("patch force, 2D, turned and sheared: quadratic " << patch_force<2>("quadratic", sheared) << ", averaged "
                                                            << patch_force<2>("quadratic_gimp", sheared) << ", gimp "
                                                            << patch_force<2>("gimp", sheared));
  const Mat<3> turned3 = 1.15 * turned<3>(0.6);
  MESSAGE("patch force, 3D, turned: quadratic " << patch_force<3>("quadratic", turned3) << ", averaged "
                                                << patch_force<3>("quadratic_gimp", turned3) << ", gimp "
                                                << patch_force<3>("gimp", turned3));
  CHECK(patch_force<2>("quadratic_gimp", sheared) < 1e-6);
  CHECK(patch_force<3>("quadratic_gimp", turned3) < 4e-4);
  CHECK(patch_force<2>("quadratic", sheared) > 2e-3);
  CHECK(patch_force<3>("quadratic", turned3) > 5e-3);
}

TEST_CASE("a domain too large for its nodes is shrunk about its centre, and told") {
  for (const BasisInfo& basis : averaged_bases()) {
    check_shrunk<2>(basis);
    check_shrunk<3>(basis);
  }
}
