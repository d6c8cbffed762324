// Constraints and contact as a convex set (THEORY T7): projection, corners, friction's corner at rest.
#include "core/solvers/feasible_set.hpp"

#include <doctest/doctest.h>

#include "tests/numerics.hpp"

using namespace pf;

namespace {

/// One node with `faces` random faces and, where asked, its last component fixed.
template <int D>
FeasibleSet<D> random_node(test::Random& random, int faces, bool fixed) {
  NodeConstraint<D> c;
  c.faces = faces;
  if (fixed) {
    c.free(D - 1, D - 1) = 0;
    c.given[D - 1] = random(-1, 1);
  }
  for (int k = 0; k < faces; ++k) {
    auto& n = c.normal[static_cast<std::size_t>(k)];
    // In every direction, but never so that the faces leave the free directions no room.
    do n = random.template vector<D>(1).normalized();
    while ((c.free * n).norm() < 0.3 ||
           (k > 0 && (c.free * n).normalized().dot((c.free * c.normal[0]).normalized()) < -0.9));
    c.offset[static_cast<std::size_t>(k)] = random(-0.5, 0.5);
  }
  FeasibleSet<D> set;
  set.constrained.push_back(c);
  return set;
}

/// A vector of one node.
template <int D>
Vector node(const Vec<D>& at) {
  Vector u(D);
  for (int a = 0; a < D; ++a) u[a] = at[a];
  return u;
}

template <int D>
bool feasible(const NodeConstraint<D>& c, const Vec<D>& u, double tolerance) {
  for (int k = 0; k < c.faces; ++k)
    if (c.normal[static_cast<std::size_t>(k)].dot(u) < c.offset[static_cast<std::size_t>(k)] - tolerance) return false;
  return (u - (c.free * u + c.given)).norm() <= tolerance;
}

/// The nearest feasible point by alternating projections with Dykstra's corrections: slow, and independent of the code.
template <int D>
Vec<D> nearest_by_dykstra(const NodeConstraint<D>& c, const Vec<D>& target) {
  Vec<D> u = c.free * target + c.given;
  std::array<Vec<D>, D> correction;
  correction.fill(Vec<D>::Zero());
  for (int sweep = 0; sweep < 4000; ++sweep)
    for (std::size_t k = 0; k < static_cast<std::size_t>(c.faces); ++k) {
      const Vec<D> from = u + correction[k], axis = c.free * c.normal[k];
      const double gap = c.normal[k].dot(from) - c.offset[k];
      u = gap < 0 ? Vec<D>(from - gap / axis.squaredNorm() * axis) : from;
      correction[k] = from - u;
    }
  return u;
}

template <int D>
void check_projection(int faces, bool fixed) {
  test::Random random(static_cast<unsigned>(1000 * D + 10 * faces + fixed));
  for (int trial = 0; trial < 60; ++trial) {
    const FeasibleSet<D> set = random_node<D>(random, faces, fixed);
    const NodeConstraint<D>& c = set.constrained[0];
    const Vec<D> start = random.vector<D>(2);
    const Vector target = node<D>(start);
    Vector u = target;
    set.project(u);
    CHECK(feasible<D>(c, u, 1e-11));
    const Vec<D> reference = nearest_by_dykstra<D>(c, start);
    if (feasible<D>(c, reference, 1e-8)) CHECK((u - node<D>(reference)).norm() < 1e-6);
    // At the nearest point nothing of the way to the target is left.
    Vector g = u - target;
    ActiveSet<D> active;
    set.active_set(u, g, active);
    CHECK(g.norm() < 1e-10);
    // Anywhere else in the set something is left, and following it comes nearer.
    Vector other = random.values(D, 2);
    set.project(other);
    if ((other - u).norm() < 1e-3) continue;
    g = other - target;
    set.active_set(other, g, active);
    CHECK(g.norm() > 1e-6);
    Vector step = other - 1e-4 * g;
    set.project(step);
    CHECK((step - target).norm() < (other - target).norm());
  }
}

/// A node on a floor that rubs with bound b.
template <int D>
FeasibleSet<D> rubbing_node(double bound) {
  NodeConstraint<D> c;
  c.faces = 1;
  c.normal[0] = c.rub_normal = Vec<D>::UnitY();
  c.wall = 0.1 * Vec<D>::UnitX();
  c.friction = 0.5;
  c.rub_bound = bound;
  FeasibleSet<D> set;
  set.constrained.push_back(c);
  return set;
}

template <int D>
void check_rubbing() {
  const FeasibleSet<D> set = rubbing_node<D>(3);
  const Vector x = Vector::Unit(D, 0), y = Vector::Unit(D, 1), rest = 0.1 * x;
  ActiveSet<D> active;
  // Pressed down and pulled by less than the bound: it sticks and does not go.
  Vector g = 2.9 * x + 10 * y;
  set.active_set(rest, g, active);
  CHECK(g.norm() == 0);
  if (D == 2) CHECK(active.directions[0].norm() < 1e-14);
  // By more: the surplus is what moves it, along the floor.
  g = 5 * x + 10 * y;
  set.active_set(rest, g, active);
  CHECK((g - 2 * x).norm() < 1e-14);
  // Pulled off the floor nothing presses.
  g = -10 * y;
  set.active_set(rest, g, active);
  CHECK((g + 10 * y).norm() < 1e-13);
  // A way that leads through rest ends there; one that does not is left alone.
  const Vector right = 0.3 * x, left = -0.2 * x;
  Vector u = left;
  set.project_from(right, g, active, u);
  CHECK((u - rest).norm() < 1e-15);
  u = 0.4 * x;
  set.project_from(right, g, active, u);
  CHECK(u[0] == doctest::Approx(0.4));
  // From rest it may go where the pull leads, not against it.
  const Vector against_x = -5 * x;
  u = right;
  set.project_from(rest, against_x, active, u);
  CHECK(u[0] == doctest::Approx(0.3));
  u = left;
  set.project_from(rest, against_x, active, u);
  CHECK((u - rest).norm() < 1e-15);
}

}  // namespace

TEST_CASE("projection finds the nearest point of the feasible set") {
  for (int faces = 0; faces <= 2; ++faces) check_projection<2>(faces, false);
  for (int faces = 0; faces <= 1; ++faces) check_projection<2>(faces, true);
  for (int faces = 0; faces <= 3; ++faces) check_projection<3>(faces, false);
  for (int faces = 0; faces <= 2; ++faces) check_projection<3>(faces, true);
}

TEST_CASE("a right-angled corner holds in every direction and lets go in every direction") {
  FeasibleSet<3> set;
  NodeConstraint<3> c;
  c.faces = 3;
  for (int k = 0; k < 3; ++k) c.normal[static_cast<std::size_t>(k)] = Vec3::Unit(k);
  set.constrained.push_back(c);
  for (int k = 0; k < 8; ++k) {
    const Vec3 target(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
    Vector u = node<3>(target);
    set.project(u);
    CHECK((u - node<3>(target.cwiseMax(0))).norm() < 1e-15);
  }
}

TEST_CASE("a rubbing node sticks up to its bound and slips beyond") {
  check_rubbing<2>();
  check_rubbing<3>();
}

TEST_CASE("directions that are left out of a step stay out") {
  test::Random random(3);
  FeasibleSet<3> set = random_node<3>(random, 2, true);
  Vector u = random.values(3, 2), g = random.values(3, 5), p = random.values(3, 1);
  set.project(u);
  ActiveSet<3> active;
  set.active_set(u, g, active);
  set.restrict_to(active.directions, p);
  CHECK(p[2] == 0);
  Vector twice = p;
  set.restrict_to(active.directions, twice);
  CHECK((twice - p).norm() < 1e-14);
  CHECK((active.directions[0] * active.directions[0] - active.directions[0]).norm() < 1e-14);
}

TEST_CASE("the natural residual is zero at a minimum, small a hair away from it, and the plain one far away") {
  const FeasibleSet<2> rubbing = rubbing_node<2>(3);
  const Vector tau = Vector::Constant(1, 0.01);
  const auto residual = [&](const Vec<2>& u, const Vec<2>& g) {
    Vector free = g;
    ActiveSet<2> active;
    rubbing.active_set(u, free, active);
    rubbing.natural_residual(u, g, tau, free);
    return free.norm();
  };
  // Pressed down with 10 N and pulled along with 2 of the 3 N that the floor can hold.
  CHECK(residual({0.1, 0}, {-2, 10}) == 0);
  for (const double gap : {1e-4, 1e-7, 1e-10}) {
    CAPTURE(gap);
    CHECK(residual({0.1, gap}, {-2, 10}) == doctest::Approx(gap / 0.01).epsilon(1e-6));
    // Sliding by a hair: g holds the friction, 3 N against the slip.
    CHECK(residual({0.1 + gap, 0}, {-2 + 3, 10}) == doctest::Approx(gap / 0.01).epsilon(1e-6));
  }
  CHECK(residual({0.1, 5}, {-0.5 - 3, 0.7}) == doctest::Approx(std::hypot(0.5 + 3 - 3, 0.7)).epsilon(1e-12));
}

TEST_CASE("the slope is the derivative along a feasible step, friction's corner included") {
  const FeasibleSet<2> set = rubbing_node<2>(3);
  const Vec<2> g(-5, 10), d(0.2, 0.1);
  CHECK(set.slope(Vec<2>(0.1, 0), g, d) == doctest::Approx(-5 * 0.2 + 10 * 0.1 + 3 * 0.2));
  CHECK(set.slope(Vec<2>(0.4, 0), g, d) == doctest::Approx(-5 * 0.2 + 10 * 0.1));
}

TEST_CASE("the active set method finds the minimum of a quadratic over a wedge") {
  // min (u - a) H (u - a) / 2 with two oblique faces: every sign pattern of the reactions is met, against the best of
  // all face subsets.
  test::Random random(5);
  int corner = 0, face = 0, inside = 0;
  for (int trial = 0; trial < 300; ++trial) {
    FeasibleSet<2> set;
    NodeConstraint<2> c;
    c.faces = 2;
    c.normal[0] = Vec<2>(0.6, 0.8);
    c.normal[1] = Vec<2>(-0.5, 0.9).normalized();
    set.constrained.push_back(c);
    Mat<2> H = Mat<2>::Identity();
    H(0, 1) = H(1, 0) = 0.8;
    const Vec<2> a = random.vector<2>(2);
    Vector u = random.values(2, 1);
    set.project(u);
    const Vector g = H * (Vec<2>(u) - a);
    ActiveSet<2> active;
    Vector free = g;
    set.active_set(u, free, active);
    Vector held = Vector::Zero(2), d = held;
    bool settled = false;
    for (int round = 0; round < 10 && !settled; ++round) {
      // Minimise over the directions: Q H Q e = -Q (g + H held), on the range of Q.
      const Mat<2> Q = active.directions[0];
      const Mat<2> A = Q * H * Q + (Mat<2>::Identity() - Q);
      d = held + Q * A.inverse() * (-(Q * (Vec<2>(g) + H * Vec<2>(held))));
      const Vector r = Vec<2>(g) + H * Vec<2>(d);
      settled = !set.update_active(u, g, d, r, 1, active, held);
    }
    REQUIRE(settled);
    const Vec<2> best = Vec<2>(u) + Vec<2>(d);
    const auto E = [&](const Vec<2>& x) { return 0.5 * (x - a).dot(H * (x - a)); };
    for (int k = 0; k < 40; ++k) {
      Vector other = best + random.vector<2>(k < 20 ? 1 : 1e-3);
      set.project(other);
      CHECK(E(other) >= E(best) - 1e-12);
    }
    const int pressed = (active.pressed[0] & 1) + (active.pressed[0] >> 1 & 1);
    (pressed == 2 ? corner : pressed == 1 ? face : inside) += 1;
  }
  CHECK(corner > 10);
  CHECK(face > 10);
  CHECK(inside > 10);
}
