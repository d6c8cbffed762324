#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/scene/sampling.hpp"
#include "core/scene/scene_io.hpp"
#include "shapes_for_tests.hpp"

using namespace pf;
using namespace pf::test;

namespace {

Scene scene_of(const Shape& shape, int dimension, double spacing, const std::string& sampling = "lattice",
               std::uint64_t seed = 0, int per_axis = 2) {
  Scene scene;
  scene.dimension = dimension;
  scene.grid.spacing = spacing;
  scene.bodies.resize(1);
  scene.bodies[0].shape = shape;
  scene.bodies[0].particles_per_axis = per_axis;
  scene.bodies[0].sampling = sampling;
  scene.bodies[0].seed = seed;
  return scene;
}

double least_distance(const std::vector<Vec3>& X) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < X.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, (X[i] - X[j]).norm());
  return least;
}

double total(const Samples& s) {
  return std::accumulate(s.volume.begin(), s.volume.end(), 0.0);
}

}  // namespace

TEST_CASE("lattice points sit at (k + 1/2) spacing/n in grid coordinates") {
  const Samples s = sample_body(scene_of(box({0.2, 0.5, 0}, {0.6, 0.9, 0}), 2, 0.05), 0);
  CHECK(s.X.size() == 16 * 16);
  CHECK(s.X[0].isApprox(Vec3(0.2125, 0.5125, 0)));
  CHECK(s.X[1].isApprox(Vec3(0.2375, 0.5125, 0)));
  CHECK(s.volume.front() == doctest::Approx(0.16 / 256));
  // A body that is not aligned keeps the grid's lattice, not its own.
  const Samples shifted = sample_body(scene_of(box({0.22, 0.5, 0}, {0.62, 0.9, 0}), 2, 0.05), 0);
  CHECK(shifted.X[0].isApprox(Vec3(0.2375, 0.5125, 0)));
  const Samples negative = sample_body(scene_of(box({-1, -1, -1}, {-0.5, -0.5, -0.5}), 3, 0.25, "lattice", 0, 1), 0);
  CHECK(negative.X.size() == 8);
  CHECK(negative.X[0].isApprox(Vec3(-0.875, -0.875, -0.875)));
}

TEST_CASE("a point on the shape's boundary belongs to it") {
  const Samples s = sample_body(scene_of(box({0.25, 0.25, 0}, {0.75, 0.75, 0}), 2, 0.5, "lattice", 0, 1), 0);
  CHECK(s.X.size() == 4);
}

TEST_CASE("volumes add up to the exact measure, whatever the sampling") {
  for (const Case& c : cases())
    for (const char* sampling : {"lattice", "jittered", "poisson_disc"}) {
      CAPTURE(c.name);
      CAPTURE(sampling);
      const double spacing = c.dimension == 2 ? 0.05 : 0.1;
      const Samples s = sample_body(scene_of(c.shape, c.dimension, 2 * spacing, sampling, 3), 0);
      CHECK(total(s) == doctest::Approx(c.measure).epsilon(std::max(c.tolerance, 1e-13)));  // a sum of thousands rounds
      CHECK(static_cast<double>(s.X.size()) ==
            doctest::Approx(c.measure / std::pow(spacing, c.dimension)).epsilon(0.3));
      const auto solid = make_solid(c.shape, c.dimension, {});
      const auto misplaced = [&](const Vec3& X) {
        return !solid->contains(X, 1e-10) || (c.dimension == 2 && X.z() != 0);
      };
      CHECK(std::ranges::count_if(s.X, misplaced) == 0);
      CHECK(static_cast<double>(s.X.size()) <= estimated_particles(scene_of(c.shape, c.dimension, 2 * spacing), 0));
    }
}

TEST_CASE("random samplings repeat with the seed and differ without") {
  for (const char* sampling : {"jittered", "poisson_disc"}) {
    const Shape shape = ball({0.3, -0.2, 0}, 1);
    const auto a = sample_body(scene_of(shape, 2, 0.1, sampling, 1), 0).X;
    const auto b = sample_body(scene_of(shape, 2, 0.1, sampling, 1), 0).X;
    const auto c = sample_body(scene_of(shape, 2, 0.1, sampling, 2), 0).X;
    CHECK(a == b);
    CHECK(a != c);
  }
}

TEST_CASE("the jittered sampling is the same on every platform") {
  const auto X = sample_body(scene_of(box({0, 0, 0}, {1, 1, 0}), 2, 1, "jittered", 42), 0).X;
  REQUIRE(X.size() == 4);
  for (int i = 0; i < 4; ++i) {
    CHECK(std::floor(X[i].x() / 0.5) == i % 2);
    CHECK(std::floor(X[i].y() / 0.5) == i / 2);
  }
}

TEST_CASE("Poisson-disc points keep their distance and leave no large hole") {
  for (const int dimension : {2, 3}) {
    const double spacing = dimension == 2 ? 0.02 : 0.1;
    const auto X = sample_body(scene_of(box({0, 0, 0}, {1, 1, 1}), dimension, 2 * spacing, "poisson_disc", 5), 0).X;
    CAPTURE(dimension);
    CAPTURE(X.size());
    const double distance = (dimension == 2 ? 0.75 : 0.8) * spacing;
    CHECK(least_distance(X) >= distance);
    CHECK(static_cast<double>(X.size()) == doctest::Approx(std::pow(spacing, -dimension)).epsilon(0.04));
    // Any point of the body has a sample within 1.6 of the least distance.
    for (double x = 0.01; x < 1; x += 0.09)
      for (double y = 0.01; y < 1; y += 0.09) {
        double nearest = 1;
        for (const Vec3& p : X) nearest = std::min(nearest, (p - Vec3(x, y, dimension == 3 ? 0.5 : 0)).norm());
        CHECK(nearest < 1.6 * distance);
      }
  }
}

TEST_CASE("separate parts are all filled") {
  const Shape two = boolean("union", {ball({0, 0, 0}, 0.5), ball({10, 0, 0}, 0.5)});
  for (const char* sampling : {"lattice", "jittered", "poisson_disc"}) {
    int left = 0, right = 0;
    for (const Vec3& X : sample_body(scene_of(two, 2, 0.1, sampling), 0).X) (X.x() < 5 ? left : right)++;
    CHECK(left > 250);
    CHECK(right > 250);
  }
}

TEST_CASE("bodies that cannot be sampled are refused by name") {
  const auto refused = [](const Scene& scene, const std::string& part) {
    try {
      (void)sample_body(scene, 0);
    } catch (const InputError& error) {
      CHECK(error.problems().at(0).pointer == "/bodies/0/shape");
      CAPTURE(error.problems().at(0).found);
      CHECK(error.problems().at(0).found.find(part) != std::string::npos);
      return;
    }
    FAIL("accepted");
  };
  refused(scene_of(box({0.01, 0.01, 0}, {0.02, 0.02, 0}), 2, 1), "no particle");
  refused(scene_of(half_space({0, 0, 0}, {0, 1, 0}), 2, 1), "without end");
  refused(scene_of(box({0, 0.25, 0}, {1, 0.25, 0}), 2, 1), "measure 0");
  refused(scene_of(box({1e300, 0, 0}, {1.1e300, 1, 0}), 2, 1), "too far");
  refused(scene_of(where("0*X - 1", {0, 0, 0}, {1, 1, 0}), 2, 0.1), "no particle");
  refused(scene_of(where("sqrt(-1 - X)", {0, 0, 0}, {1, 1, 0}), 2, 0.1), "no particle");
}

TEST_CASE("a thin shape across large bounds is sampled at the cost of its particles") {
  // A bounding box of 4e10 lattice points; the strip holds some 1e5.
  const Shape strip = moved(box({-50, -0.0005, 0}, {50, 0.0005, 0}), 1, 30, {0, 0, 0});
  const Samples s = sample_body(scene_of(strip, 2, 0.001), 0);
  CHECK(static_cast<double>(s.X.size()) == doctest::Approx(0.1 / 0.25e-6).epsilon(0.01));
}

TEST_CASE("the number of particles is foreseen without making them") {
  CHECK(estimated_particles(scene_of(box({0, 0, 0}, {1, 1, 1}), 3, 1e-6), 0) > 1e18);
  CHECK(std::isinf(estimated_particles(scene_of(half_space({0, 0, 0}, {0, 1, 0}), 2, 1), 0)));
  const double n = estimated_particles(scene_of(ball({0, 0, 0}, 1), 3, 0.02), 0);
  CHECK(n > 4.18e6);
  CHECK(n < 5e6);
  const Shape shell = boolean("difference", {ball({0, 0, 0}, 1), ball({0, 0, 0}, 0.99)});
  const double m = estimated_particles(scene_of(shell, 3, 0.002), 0);  // of 8e9 lattice points within its bounds
  CHECK(m > 1.24e8);
  CHECK(m < 2.5e8);
}
