#include <doctest/doctest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "core/scene/manufactured.hpp"
#include "core/scene/scene_io.hpp"

using namespace pf;

namespace {

constexpr double pi = std::numbers::pi;

Scene scene_of(const std::vector<std::string>& position, const Constants& constants) {
  Scene scene;
  scene.dimension = static_cast<int>(position.size());
  scene.constants = constants;
  for (const std::string& text : position) scene.exact_position.push_back({0, text});
  return scene;
}

template <int D>
Vec<D> body_acceleration(const ExactMotion<D>& motion, const Law<D>& law, double density, const Vec<D>& gravity,
                         const Vec<D>& X, double t) {
  Vec<D> b;
  ManufacturedLoads<D>(motion, law, density, gravity)
      .body_acceleration(std::span<const Vec<D>>(&X, 1), t, std::span<Vec<D>>(&b, 1));
  return b;
}

struct Elastic {
  double E, nu, mu = E / (2 * (1 + nu)), lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
  template <int D>
  std::unique_ptr<Law<D>> law(std::string_view name) const {
    const std::array<double, 2> parameters = {E, nu};
    return make_law<D>(name, parameters);
  }
};

const std::vector<std::string> axis_aligned = {"X + A*sin(2*pi*X)*sin(c*pi*t)", "Y + A*sin(2*pi*Y)*sin(c*pi*t + pi)"};

}  // namespace

TEST_CASE("an exact motion gives position, velocity, acceleration and F") {
  const double A = 0.05, c = 10, X = 0.3, Y = 0.8, t = 0.07;
  const ExactMotion<2> motion(scene_of(axis_aligned, {{"A", A}, {"c", c}}));
  const MotionPoint<2> p = motion.at({X, Y}, t);
  const double s = std::sin(c * pi * t), ds = c * pi * std::cos(c * pi * t), dds = -c * pi * c * pi * s;
  CHECK(p.position.isApprox(Vec<2>(X + A * std::sin(2 * pi * X) * s, Y - A * std::sin(2 * pi * Y) * s)));
  CHECK(p.velocity.isApprox(Vec<2>(A * std::sin(2 * pi * X) * ds, -A * std::sin(2 * pi * Y) * ds)));
  CHECK(p.acceleration.isApprox(Vec<2>(A * std::sin(2 * pi * X) * dds, -A * std::sin(2 * pi * Y) * dds)));
  CHECK(p.F(0, 0) == doctest::Approx(1 + 2 * A * pi * std::cos(2 * pi * X) * s));
  CHECK(p.F(0, 1) == 0);
  CHECK(motion.position({X, Y}, t) == p.position);
  CHECK(motion.F({X, Y}, t) == p.F);
}

TEST_CASE("a wrong exact motion is refused with its place") {
  try {
    (void)ExactMotion<2>(scene_of({"X", "Y + sinn(t)"}, {}));
    FAIL("accepted");
  } catch (const InputError& error) {
    CHECK(error.problems().at(0).pointer == "/exact/position/1");
  }
  CHECK_THROWS_AS((void)ExactMotion<3>(scene_of({"X", "Y"}, {})), InputError);
}

TEST_CASE("the axis-aligned manufactured solution's body acceleration (Wallstedt and Guilkey 2008)") {
  const Elastic material{1e7, 0.3};
  const double rho = 1000, A = 0.05, c = std::sqrt(material.E / rho);
  const auto [E, nu, mu, lambda] = material;
  const ExactMotion<2> motion(scene_of(axis_aligned, {{"A", A}, {"c", c}}));
  const auto law = material.law<2>("neo_hookean");
  for (const double t : {0.0, 0.001, 0.004, 0.017})
    for (const Vec<2>& X : {Vec<2>(0.1, 0.2), Vec<2>(0.45, 0.9), Vec<2>(0.7, 0.33)}) {
      const MotionPoint<2> p = motion.at(X, t);
      const Vec<2> u = p.position - X;
      Vec<2> expected;
      for (int a = 0; a < 2; ++a) {
        const double F2 = p.F(a, a) * p.F(a, a), lnJ = std::log(p.F(0, 0) * p.F(1, 1));
        expected[a] = pi * pi * u[a] * (4 * mu / rho - c * c - 4 * (lambda * (lnJ - 1) - mu) / (rho * F2));
      }
      const Vec<2> b = body_acceleration<2>(motion, *law, rho, Vec<2>::Zero(), X, t);
      CHECK((b - expected).norm() <= 1e-10 * (1 + expected.norm()));
    }
}

TEST_CASE("in one direction with nu = 0 it is that of P = E/2 (F - 1/F) (Steffen 2008)") {
  const Elastic material{1e4, 0};
  const double rho = 10, A = 0.08, c = std::sqrt(material.E / rho);
  const ExactMotion<2> motion(scene_of({"X + A*sin(2*pi*X)*cos(c*pi*t)", "Y"}, {{"A", A}, {"c", c}}));
  const auto law = material.law<2>("neo_hookean");
  for (const double X : {0.05, 0.3, 0.61, 0.9}) {
    const double t = 0.013;
    const MotionPoint<2> p = motion.at({X, 0.4}, t);
    const double u = p.position[0] - X, F = p.F(0, 0);
    const double expected = pi * pi * u * (-c * c + 2 * material.E / rho * (1 + 1 / (F * F)));
    const Vec<2> b = body_acceleration<2>(motion, *law, rho, {0, -9.81}, {X, 0.4}, t);
    CHECK(b[0] == doctest::Approx(expected).epsilon(1e-10));
    CHECK(b[1] == doctest::Approx(9.81).epsilon(1e-10));  // gravity is taken off: nothing moves in y
    // Traction on the face with normal x.
    const Vec<2> at(X, 0.4), N(1, 0);
    Vec<2> traction;
    ManufacturedLoads<2>(motion, *law, rho, Vec<2>::Zero())
        .traction(std::span<const Vec<2>>(&at, 1), std::span<const Vec<2>>(&N, 1), t, std::span<Vec<2>>(&traction, 1));
    CHECK(traction[0] == doctest::Approx(material.E / 2 * (F - 1 / F)));
    CHECK(std::abs(traction[1]) < 1e-9 * material.E);
  }
}

TEST_CASE("the generalised vortex's body acceleration (Kamojjala et al. 2015)") {
  const Elastic material{1000, 0.3};
  const double rho = 1000, c = 1, t = 0.3;
  const std::string R = "sqrt(X^2 + Y^2)", h = "(1 - 32*(" + R + " - 1)^2 + 256*(" + R + " - 1)^4)",
                    a = "sin(pi*c*t)*" + h;
  const ExactMotion<2> motion(
      scene_of({"X*cos(" + a + ") - Y*sin(" + a + ")", "X*sin(" + a + ") + Y*cos(" + a + ")"}, {{"c", c}}));
  const auto law = material.law<2>("neo_hookean");
  const double g = std::sin(pi * c * t), dg = pi * c * std::cos(pi * c * t), ddg = -pi * c * pi * c * g;
  for (const double radius : {0.8, 0.95, 1.1, 1.2})
    for (const double angle : {0.3, 2.0, 4.0}) {
      const Vec<2> X(radius * std::cos(angle), radius * std::sin(angle));
      const double s = radius - 1, hh = 1 - 32 * s * s + 256 * s * s * s * s, dh = -64 * s + 1024 * s * s * s,
                   ddh = -64 + 3072 * s * s;
      const MotionPoint<2> p = motion.at(X, t);
      CHECK(p.F.determinant() == doctest::Approx(1));
      const Vec<2> er = p.position / radius, etheta(-er[1], er[0]);
      const double br = -radius * dg * dg * hh * hh + material.mu / rho * radius * g * dh * g * dh;
      const double btheta = radius * ddg * hh - material.mu / rho * (3 * g * dh + radius * g * ddh);
      const Vec<2> b = body_acceleration<2>(motion, *law, rho, Vec<2>::Zero(), X, t);
      CHECK(b.dot(er) == doctest::Approx(br).epsilon(1e-9).scale(10));
      CHECK(b.dot(etheta) == doctest::Approx(btheta).epsilon(1e-9).scale(10));
    }
}

TEST_CASE_TEMPLATE("Div P by the law's tangent agrees with differences of its stress, for every law", T,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
  constexpr int D = T::value;
  std::vector<std::string> position = {"X + 0.1*sin(X + 2*Y)*cos(t)", "Y*(1 + 0.1*X*t) - 0.05*t^2"};
  if (D == 3) {
    position[0] += " + 0.07*X*Z";
    position.push_back("Z + 0.1*sin(Z*Y)*t + 0.03*X^2");
  }
  const ExactMotion<D> motion(scene_of(position, {}));
  Vec<D> X = Vec<D>::Constant(0.4);
  X[1] = 0.7;
  const double t = 0.6, rho = 3, h = 1e-5;
  const Vec<D> gravity = -9.81 * Vec<D>::Unit(1);
  for (const LawInfo& info : laws()) {
    CAPTURE(info.name);
    std::vector<double> parameters;
    for (const LawParameter& parameter : info.parameters) parameters.push_back(parameter.typical);
    const auto law = make_law<D>(info.name, parameters);
    const auto P = [&](const Vec<D>& at) {
      const Mat<D> F = motion.F(at, t);
      Mat<D> stress;
      double psi;
      law->stress(std::span<const Mat<D>>(&F, 1), std::span<double>(&psi, 1), std::span<Mat<D>>(&stress, 1));
      return stress;
    };
    Vec<D> div = Vec<D>::Zero();
    for (int A = 0; A < D; ++A) div += (P(X + h * Vec<D>::Unit(A)) - P(X - h * Vec<D>::Unit(A))).col(A) / (2 * h);
    const Vec<D> expected = motion.acceleration(X, t) - div / rho - gravity;
    const Vec<D> b = body_acceleration<D>(motion, *law, rho, gravity, X, t);
    CHECK((b - expected).norm() <= 1e-6 * expected.norm());
  }
}

TEST_CASE("a batch of any length gives what single points give") {
  const Elastic material{1e5, 0.3};
  const ExactMotion<2> motion(scene_of(axis_aligned, {{"A", 0.05}, {"c", 10}}));
  const auto law = material.law<2>("neo_hookean");
  std::vector<Vec<2>> X;
  for (int i = 0; i < 77; ++i) X.emplace_back(0.013 * i, 1 - 0.011 * i);
  std::vector<Vec<2>> b(X.size());
  ManufacturedLoads<2>(motion, *law, 1000, {0, -1}).body_acceleration(X, 0.02, b);
  for (std::size_t i = 0; i < X.size(); ++i)
    CHECK(b[i] == body_acceleration<2>(motion, *law, 1000, {0, -1}, X[i], 0.02));
}
