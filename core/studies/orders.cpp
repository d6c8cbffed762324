#include "core/studies/orders.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace pf {

namespace {

constexpr double straight = 0.05;  // [decades]

/// Least squares through points [first, last).
FittedOrder line_through(const std::vector<std::pair<double, double>>& points, std::size_t first, std::size_t last) {
  const double n = static_cast<double>(last - first);
  double x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t k = first; k < last; ++k) x += points[k].first / n, y += points[k].second / n;
  for (std::size_t k = first; k < last; ++k) {
    xx += (points[k].first - x) * (points[k].first - x);
    xy += (points[k].first - x) * (points[k].second - y);
  }
  FittedOrder fit;
  fit.order = xy / xx;
  fit.points = last - first;
  fit.from = std::pow(10, points[first].first);
  fit.to = std::pow(10, points[last - 1].first);
  for (std::size_t k = first; k < last; ++k)
    fit.residual = std::max(fit.residual, std::abs(points[k].second - y - fit.order * (points[k].first - x)));
  return fit;
}

}  // namespace

FittedOrder fit_order(std::span<const double> x, std::span<const double> error) {
  std::vector<std::pair<double, double>> points;
  for (std::size_t k = 0; k < std::min(x.size(), error.size()); ++k)
    if (x[k] > 0 && error[k] > 0 && std::isfinite(x[k]) && std::isfinite(error[k]))
      points.emplace_back(std::log10(x[k]), std::log10(error[k]));
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end(), [](auto& a, auto& b) { return a.first == b.first; }),
               points.end());
  FittedOrder best;
  best.order = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t count = points.size(); count >= 3 && best.points == 0; --count)
    for (std::size_t first = points.size() - count + 1; first-- > 0 && best.points == 0;) {
      const FittedOrder fit = line_through(points, first, first + count);
      if (fit.residual <= straight) best = fit;
    }
  return best;
}

}  // namespace pf
