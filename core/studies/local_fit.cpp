#include "core/studies/local_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

namespace pf {

namespace {

constexpr double radius_in_cells = 1.6;  ///< holds 30 particles in 2D at 2 an axis, 130 in 3D
constexpr int widenings = 4;             ///< by half as much again, where there are too few
constexpr double ridge = 1e-9;           ///< relative: a direction without particles gets no slope

/// 1, x, y, [z,] x^2, x y, ...: monomials in units of the radius.
int monomials(int d, const Vec3& r, std::array<double, 10>& value) {
  int n = 0;
  value[n++] = 1;
  for (int a = 0; a < d; ++a) value[n++] = r[a];
  for (int a = 0; a < d; ++a)
    for (int b = a; b < d; ++b) value[n++] = r[a] * r[b];
  return n;
}

}  // namespace

LocalFit::LocalFit(int dimension, std::vector<Vec3> X, std::vector<std::uint16_t> body, double spacing)
    : dimension_(dimension), X_(std::move(X)), spacing_(spacing) {
  for (std::size_t p = 0; p < X_.size(); ++p) cells_[cell_of(X_[p], body[p])].push_back(static_cast<std::uint32_t>(p));
}

LocalFit::Cell LocalFit::cell_of(const Vec3& X, std::uint16_t body) const {
  Cell cell{body, {}};
  for (int a = 0; a < 3; ++a)
    cell.second[static_cast<std::size_t>(a)] =
        a < dimension_ ? static_cast<std::int64_t>(std::floor(X[a] / spacing_)) : 0;
  return cell;
}

std::vector<std::uint32_t> LocalFit::around(const Vec3& X, std::uint16_t body, double radius) const {
  std::vector<std::uint32_t> found;
  const Cell low = cell_of(X - Vec3::Constant(radius), body), high = cell_of(X + Vec3::Constant(radius), body);
  Cell cell = low;
  for (auto k = low.second[2]; k <= high.second[2]; ++k)
    for (auto j = low.second[1]; j <= high.second[1]; ++j)
      for (auto i = low.second[0]; i <= high.second[0]; ++i) {
        cell.second = {i, j, k};
        const auto here = cells_.find(cell);
        if (here == cells_.end()) continue;
        for (const std::uint32_t p : here->second)
          if ((X_[p] - X).squaredNorm() < radius * radius) found.push_back(p);
      }
  return found;
}

FitWeights LocalFit::at(const Vec3& X, std::uint16_t body) const {
  const std::size_t wanted = dimension_ == 2 ? 9 : 14;
  double radius = radius_in_cells * spacing_;
  std::vector<std::uint32_t> near = around(X, body, radius);
  for (int k = 0; k < widenings && near.size() < wanted; ++k) near = around(X, body, radius *= 1.5);
  if (near.empty()) return {};
  const int n = dimension_ == 2 ? 6 : 10;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
  std::vector<double> weight;
  std::vector<Eigen::VectorXd> rows;
  std::array<double, 10> value{};
  for (const std::uint32_t p : near) {
    const Vec3 r = (X_[p] - X) / radius;
    const double inside = 1 - r.squaredNorm();
    weight.push_back(inside * inside);
    monomials(dimension_, r, value);
    rows.emplace_back(Eigen::Map<const Eigen::VectorXd>(value.data(), n));
    normal += weight.back() * rows.back() * rows.back().transpose();
  }
  // The constant is never held back: values of constants come out exactly.
  const double small = ridge * normal.trace();
  for (int k = 1; k < n; ++k) normal(k, k) += small;
  const Eigen::VectorXd row = normal.ldlt().solve(Eigen::VectorXd::Unit(n, 0));
  FitWeights weights;
  for (std::size_t k = 0; k < near.size(); ++k) weights.emplace_back(near[k], weight[k] * row.dot(rows[k]));
  return weights;
}

Roughness roughness(std::span<const FitWeights> fits, std::span<const double> f, std::size_t components,
                    std::span<const double> mass) {
  double noise = 0, size = 0, total = 0;
  for (std::size_t p = 0; p < fits.size(); ++p) {
    total += mass[p];
    for (std::size_t c = 0; c < components; ++c) {
      double fit = 0;
      for (const auto& [q, weight] : fits[p]) fit += weight * f[q * components + c];
      const double value = f[p * components + c];
      size += mass[p] * value * value;
      if (!fits[p].empty()) noise += mass[p] * (value - fit) * (value - fit);
    }
  }
  return total > 0 ? Roughness{std::sqrt(noise / total), std::sqrt(size / total)} : Roughness{};
}

}  // namespace pf
