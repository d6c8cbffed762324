// What the tests of material laws share: parameters, deformations, one law evaluated at one F.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <random>
#include <vector>

#include "core/materials/law.hpp"

namespace pf::test {

inline std::vector<double> typical_parameters(const LawInfo& info) {
  std::vector<double> values;
  for (const LawParameter& parameter : info.parameters) values.push_back(parameter.typical);
  return values;
}

/// Entries uniform in [-1, 1], the same for the same seed.
template <int D>
Mat<D> random_matrix(unsigned seed) {
  std::mt19937 engine(seed);
  return Mat<D>::NullaryExpr([&] { return 2 * (static_cast<double>(engine()) / 4294967295.0) - 1; });
}

template <int D>
Mat<D> rotation(double angle) {
  if constexpr (D == 2) return Eigen::Rotation2Dd(angle).toRotationMatrix();
  if constexpr (D == 3) return Eigen::AngleAxisd(angle, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
}

/// R diag(s) V^T with rotations R, V.
template <int D>
Mat<D> stretched(const Vec<D>& s, double angle_u, double angle_v) {
  return rotation<D>(angle_u) * s.asDiagonal() * rotation<D>(angle_v).transpose();
}

/// det F > 0: identity, small and large strain, equal and nearly equal stretches, compression, rotation.
template <int D>
std::vector<Mat<D>> deformations() {
  const auto stretch = [](double a, double b, double c) { return Vec<D>(Vec3(a, b, c).head<D>()); };
  std::vector<Mat<D>> list = {Mat<D>::Identity(),
                              rotation<D>(1.1),
                              stretched<D>(stretch(1.3, 1.3, 1.3), 0.4, 2.0),
                              stretched<D>(stretch(0.6, 0.6, 0.9), 0.4, 2.0),
                              stretched<D>(stretch(1.2, 1.2 * (1 + 1e-9), 0.7), -0.4, 1.0),
                              stretched<D>(stretch(1.2, 1.2 * (1 + 1e-5), 1.2), -0.4, 1.0),
                              stretched<D>(stretch(0.3, 1.4, 2.5), 0.9, -0.3),
                              stretched<D>(stretch(0.25, 0.2, 0.3), 0.1, 0.2),
                              stretched<D>(stretch(3.0, 0.4, 1.0), 2.9, 0.7)};
  for (unsigned seed = 1; seed <= 6; ++seed)
    list.push_back(Mat<D>(Mat<D>::Identity() + (seed < 4 ? 0.2 : 0.01) * random_matrix<D>(seed)));
  return list;
}

template <int D>
struct Response {
  double psi = 0;
  Mat<D> P;
  Tangent<D> dP, projected;
};

template <int D>
Response<D> evaluate(const Law<D>& law, const Mat<D>& F) {
  Response<D> response;
  law.stress({&F, 1}, {&response.psi, 1}, {&response.P, 1});
  law.tangent({&F, 1}, false, {&response.dP, 1});
  law.tangent({&F, 1}, true, {&response.projected, 1});
  return response;
}

template <int D>
double energy(const Law<D>& law, const Mat<D>& F) {
  double psi = 0;
  law.energy({&F, 1}, {&psi, 1});
  return psi;
}

}  // namespace pf::test
