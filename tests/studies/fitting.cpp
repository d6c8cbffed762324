// Orders and fronts on data of which everything is known; local fits of known fields.
#include <doctest/doctest.h>

#include <cmath>

#include "core/charts/chart.hpp"
#include "core/studies/local_fit.hpp"
#include "core/studies/measure.hpp"
#include "core/studies/orders.hpp"

using namespace pf;

TEST_CASE("fitted orders: pure powers exactly, a floor left out, scatter refused") {
  const std::vector<double> h{0.1, 0.05, 0.025, 0.0125, 0.00625};
  std::vector<double> error;
  for (const double x : h) error.push_back(3 * std::pow(x, 1.7));
  FittedOrder fit = fit_order(h, error);
  CHECK(fit.order == doctest::Approx(1.7).epsilon(1e-12));
  CHECK(fit.points == 5);
  CHECK(fit.residual < 1e-12);
  // A floor that the last two reach: the order is that of the first three.
  error[3] = error[4] = error[2];
  fit = fit_order(h, error);
  CHECK(fit.order == doctest::Approx(1.7).epsilon(1e-6));
  CHECK(fit.points == 3);
  CHECK(fit.from == doctest::Approx(0.025));
  CHECK(fit.to == doctest::Approx(0.1));
  // A factor of two up and down is no line.
  CHECK(std::isnan(fit_order(h, std::vector<double>{1, 2, 1, 2, 1}).order));
  CHECK(std::isnan(fit_order(std::vector<double>{1, 2}, std::vector<double>{1, 2}).order));
  CHECK(fit_order(std::vector<double>{4, 2, 0, 1}, std::vector<double>{4, 2, 5, 1}).order == doctest::Approx(1));
}

TEST_CASE("fronts: near-ties and overlapping error bars count as ties") {
  Chart chart;
  chart.series.push_back({.x = {1, 2, 2.01, 4}, .y = {8, 4, 4, 5}});
  const auto front = [&chart] {
    std::vector<std::size_t> index;
    for (const PointId id : pareto_front(chart)) index.push_back(id.index);
    return index;
  };
  CHECK(front() == std::vector<std::size_t>{0, 1});
  chart.pareto_ties = 0.01;
  CHECK(front() == std::vector<std::size_t>{0, 1, 2});
  chart.pareto_ties = 0;
  chart.series[0].x_low = {0.9, 1.8, 1.9, 1.9};
  chart.series[0].x_high = {1.1, 2.2, 2.2, 4.1};
  // The last has a worse error, and its cost is not clearly better than anybody's.
  CHECK(front() == std::vector<std::size_t>{0, 1, 2});
  chart.series[0].y = {8, 4, 3.9, 5};
  CHECK(front() == std::vector<std::size_t>{0, 2});  // as cheap as the second, and better
}

TEST_CASE("a local fit reproduces quadratics and calls only what is rough noise") {
  for (const int d : {2, 3}) {
    CAPTURE(d);
    std::vector<Vec3> X;
    std::vector<std::uint16_t> body;
    const int n = d == 2 ? 20 : 10;
    for (int k = 0; k < (d == 2 ? 1 : n); ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) X.push_back({0.05 * i, 0.05 * j, 0.05 * k}), body.push_back(0);
    const LocalFit fit(d, X, body, 0.1);
    const auto f = [](const Vec3& x) { return 1 + x[0] - 2 * x[1] + x[0] * x[1] + 3 * x[2] * x[2] - x[1] * x[1]; };
    const Vec3 at{0.231, 0.317, d == 2 ? 0.0 : 0.123};
    double value = 0;
    for (const auto& [p, weight] : fit.at(at, 0)) value += weight * f(X[p]);
    CHECK(value == doctest::Approx(f(at)).epsilon(1e-6));
    CHECK(fit.at(at, 1).empty());  // no such body
    std::vector<FitWeights> fits;
    std::vector<double> smooth, rough, mass(X.size(), 2.0);
    for (std::size_t p = 0; p < X.size(); ++p) {
      fits.push_back(fit.at(X[p], 0));
      smooth.push_back(f(X[p]));
      const int parity = static_cast<int>(std::lround((X[p][0] + X[p][1] + X[p][2]) / 0.05)) % 2;
      rough.push_back(f(X[p]) + (parity != 0 ? 0.1 : -0.1));
    }
    CHECK(roughness(fits, smooth, 1, mass).noise < 1e-6);
    CHECK(roughness(fits, rough, 1, mass).noise == doctest::Approx(0.1).epsilon(0.25));
  }
}

TEST_CASE("classes follow the thresholds, the worst first") {
  const StudyThresholds thresholds;
  StudyRow row;
  CHECK(classify(row, thresholds) == RunClass::good);  // nothing known
  row.energy_lost = 0.2;
  CHECK(classify(row, thresholds) == RunClass::damped);
  row.stress_noise = 0.3;
  CHECK(classify(row, thresholds) == RunClass::noisy);
  row.energy_gained = 0.06;
  CHECK(classify(row, thresholds) == RunClass::growing);
  row.energy_gained = 11;
  CHECK(classify(row, thresholds) == RunClass::blown_up);
}
