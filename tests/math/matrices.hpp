// Matrices that are easy, hard and degenerate, and the way between Eigen's matrices and ours.
#pragma once

#include <Eigen/Geometry>
#include <random>
#include <vector>

#include "core/math/small_linalg.hpp"
#include "core/types.hpp"

namespace pf::test {

template <int D>
Square<double, D> square(const Mat<D>& A) {
  Square<double, D> S;
  for (int k = 0; k < D * D; ++k) S.e[k] = A.data()[k];
  return S;
}

template <int D>
Mat<D> eigen(const Square<double, D>& A) {
  return Mat<D>(A.e);
}

/// Lane by lane.
template <int D>
Square<Pack, D> pack(const std::vector<Mat<D>>& list, std::size_t first) {
  Square<Pack, D> S;
  for (int lane = 0; lane < 8; ++lane)
    for (int k = 0; k < D * D; ++k)
      S.e[k][lane] = list[(first + static_cast<std::size_t>(lane)) % list.size()].data()[k];
  return S;
}

template <int D>
Square<double, D> lane(const Square<Pack, D>& A, int which) {
  Square<double, D> S;
  for (int k = 0; k < D * D; ++k) S.e[k] = A.e[k][which];
  return S;
}

/// Zero, rank 1 and 2, equal and nearly equal singular values, rotations, reflections, tiny, huge, mixed scales,
/// random.
template <int D>
std::vector<Mat<D>> hard_matrices() {
  std::mt19937 engine(5);
  const auto uniform = [&engine] { return 2 * (static_cast<double>(engine()) / 4294967295.0) - 1; };
  const auto random = [&] { return Mat<D>(Mat<D>::NullaryExpr(uniform)); };
  const auto rotated = [](double a, double b, double c) {
    Mat<D> Q, R;
    if constexpr (D == 2) {
      Q = Eigen::Rotation2Dd(0.7).toRotationMatrix();
      R = Eigen::Rotation2Dd(-2.1).toRotationMatrix();
    } else {
      Q = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
      R = Eigen::AngleAxisd(-2.1, Vec3(3, -1, 0.2).normalized()).toRotationMatrix();
    }
    const Vec<D> s = Vec3(a, b, c).head<D>();
    return Mat<D>(Q * s.asDiagonal() * R.transpose());
  };
  std::vector<Mat<D>> list = {Mat<D>::Zero(),
                              Mat<D>::Identity(),
                              Mat<D>(-Mat<D>::Identity()),
                              Mat<D>::Ones(),
                              rotated(1, 1, 1),
                              rotated(1, 1, -1),
                              rotated(-1, 1, 1),
                              rotated(2, 2, 0.5),
                              rotated(2, 0.5, 0.5),
                              rotated(1, 0, 0),
                              rotated(1, 1, 0),
                              rotated(1, 1e-9, 1e-12),
                              rotated(1, 1 + 1e-9, 1 - 1e-12),
                              rotated(1, 1 + 4e-16, 1),
                              rotated(1e-160, 3e-160, 2e-160),
                              rotated(1e150, 1e150, 3e150),
                              rotated(1e100, 1, 1e-100),
                              rotated(5, -3, -1e-3)};
  Mat<D> row = Mat<D>::Zero();
  row(0, D - 1) = 3;
  list.push_back(row);
  Mat<D> diagonal = Mat<D>::Identity();
  diagonal(0, 0) = 1e-300;
  list.push_back(diagonal);
  for (int n = 0; n < 2000; ++n) list.push_back(random());
  for (int n = 0; n < 2000; ++n)
    list.push_back(Mat<D>::Identity() + std::pow(10.0, -16.0 * std::abs(uniform())) * random());
  for (int n = 0; n < 2000; ++n) {
    const double e = std::pow(10.0, -12 * std::abs(uniform()));
    list.push_back(rotated(uniform(), e * uniform(), e * e * uniform()) + e * 1e-3 * random());
  }
  return list;
}

}  // namespace pf::test
