// Particles that follow a body's surface: they integrate quadratic functions over the body.
#include <doctest/doctest.h>

#include <numbers>
#include <numeric>

#include "core/scene/sampling.hpp"
#include "core/scene/scene_io.hpp"
#include "shapes_for_tests.hpp"

using namespace pf;
using namespace pf::test;

namespace {

Scene scene_of(const Shape& shape, int dimension, double spacing, const std::string& sampling = "fitted") {
  Scene scene;
  scene.dimension = dimension;
  scene.grid.spacing = spacing;
  scene.bodies.resize(1);
  scene.bodies[0].shape = shape;
  scene.bodies[0].particles_per_axis = 2;
  scene.bodies[0].sampling = sampling;
  return scene;
}

/// Integrals of 1, x and x x^T over the domains of all particles.
struct Sums {
  double one = 0;
  Vec3 x = Vec3::Zero();
  Mat3 xx = Mat3::Zero();
  explicit Sums(const Samples& s) {
    for (std::size_t p = 0; p < s.X.size(); ++p) {
      one += s.volume[p];
      x += s.volume[p] * s.X[p];
      const Mat3 cube = std::cbrt(s.volume[p]) * Mat3::Identity();
      const Mat3& E = s.domain.empty() ? cube : s.domain[p];
      xx += s.volume[p] * (s.X[p] * s.X[p].transpose() + E * E.transpose() / 12);
    }
  }
};

}  // namespace

TEST_CASE("a body along the lattice is sampled as by the lattice") {
  for (const int dimension : {2, 3}) {
    const Shape shape = box({0.2, 0.5, dimension == 3 ? -0.1 : 0.0}, {0.6, 0.9, dimension == 3 ? 0.1 : 0.0});
    const Samples fitted = sample_body(scene_of(shape, dimension, 0.1), 0),
                  lattice = sample_body(scene_of(shape, dimension, 0.1, "lattice"), 0);
    CHECK(fitted.X == lattice.X);
    REQUIRE(fitted.volume.size() == lattice.volume.size());
    for (std::size_t p = 0; p < fitted.volume.size(); ++p)
      CHECK(fitted.volume[p] == doctest::Approx(lattice.volume[p]).epsilon(1e-14));
    Mat3 cube = Mat3::Zero();
    for (int a = 0; a < dimension; ++a) cube(a, a) = 0.05;
    for (const Mat3& domain : fitted.domain) CHECK(domain == cube);
  }
}

TEST_CASE("fitted particles have the area, centre and second moments of a disc, off the lattice") {
  using std::numbers::pi;
  const Vec3 centre(0.313, -0.127, 0);
  const double R = 0.41;
  double before = 0;
  for (const double spacing : {0.2, 0.1, 0.05}) {
    const Sums sums(sample_body(scene_of(ball(centre, R), 2, spacing), 0)),
        stairs(sample_body(scene_of(ball(centre, R), 2, spacing, "lattice"), 0));
    CHECK(sums.one == doctest::Approx(pi * R * R).epsilon(1e-12));
    CHECK((sums.x / sums.one - centre).norm() < 2e-4 * spacing);
    const Mat3 covariance = sums.xx / sums.one - centre * centre.transpose();
    const double error = std::max(std::abs(covariance(0, 0) - R * R / 4), std::abs(covariance(1, 1) - R * R / 4));
    CHECK(error < 1e-3 * spacing * spacing);
    CHECK(std::abs(covariance(0, 1)) < 1e-4 * spacing * spacing);
    const Mat3 rough = stairs.xx / stairs.one - (stairs.x / stairs.one) * (stairs.x / stairs.one).transpose();
    CHECK(std::abs(rough(0, 0) - R * R / 4) > 5 * error);
    if (before > 0) CHECK(error < 0.5 * before);
    before = error;
  }
}

TEST_CASE("fitted particles have the moments of a ball and of a slanted box") {
  using std::numbers::pi;
  const double R = 0.37;
  const Sums round(sample_body(scene_of(ball({1e4 + 0.11, 0.2, -0.07}, R), 3, 0.1), 0));
  CHECK(round.one == doctest::Approx(4.0 / 3 * pi * R * R * R).epsilon(1e-12));
  CHECK(round.xx(1, 1) / round.one - 0.2 * 0.2 == doctest::Approx(R * R / 5).epsilon(3e-4));
  const Shape slanted = moved(box({0, 0, 0}, {0.5, 0.2, 0}), 1, 30, {0, 0, 0});
  const Sums bar(sample_body(scene_of(slanted, 2, 0.1), 0));
  const Vec3 along(std::cos(pi / 6), std::sin(pi / 6), 0), middle(0.25, 0.1, 0);
  CHECK(bar.one == doctest::Approx(0.1).epsilon(1e-12));
  CHECK((bar.x / bar.one - middle).norm() < 1e-5);
  const Mat3 covariance = bar.xx / bar.one - middle * middle.transpose();
  CHECK(along.dot(covariance * along) == doctest::Approx(0.25 / 12).epsilon(1e-3));
}

TEST_CASE("no fitted particle is smaller than a quarter of a cell unless the body is") {
  const Samples s = sample_body(scene_of(ball({0.313, -0.127, 0}, 0.41), 2, 0.05), 0);
  for (std::size_t p = 0; p < s.X.size(); ++p) {
    CHECK(s.volume[p] > 0.24 * 0.025 * 0.025);
    CHECK(s.volume[p] < 1.76 * 0.025 * 0.025);
  }
  // A plate thinner than that, between two rows of lattice points, which the lattice does not see.
  const Shape plate = box({0, 0.026, 0}, {0.5, 0.029, 0});
  CHECK_THROWS_AS((void)sample_body(scene_of(plate, 2, 0.05, "lattice"), 0), InputError);
  const Samples thin = sample_body(scene_of(plate, 2, 0.05), 0);
  CHECK(thin.X.size() == 20);
  CHECK(thin.volume.front() == doctest::Approx(0.025 * 0.003));
  CHECK(thin.X.front().y() == doctest::Approx(0.0275).epsilon(1e-3));
}
