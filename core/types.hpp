// The small fixed-size types and the few names that every folder of core uses.
#pragma once

#include <Eigen/Core>

namespace pf {

template <int D>
using Vec = Eigen::Matrix<double, D, 1>;
template <int D>
using Mat = Eigen::Matrix<double, D, D>;
/// d vec(P) / d vec(F): both in column-major order, so component (a, B) has index a + D*B.
template <int D>
using Tangent = Eigen::Matrix<double, D * D, D * D>;
using Vec3 = Vec<3>;
using Mat3 = Mat<3>;
using Vector = Eigen::VectorXd;

}  // namespace pf
