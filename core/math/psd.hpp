// The nearest positive semi-definite matrix.
#pragma once

#include "core/types.hpp"

namespace pf {

/// Replaces a symmetric A by the nearest positive semi-definite matrix in the Frobenius norm (negative eigenvalues
/// become zero). A with entries that are not finite is left as it is.
template <int N>
void project_psd(Eigen::Matrix<double, N, N>& A);

extern template void project_psd<2>(Eigen::Matrix<double, 2, 2>&);
extern template void project_psd<3>(Eigen::Matrix<double, 3, 3>&);
extern template void project_psd<4>(Eigen::Matrix<double, 4, 4>&);
extern template void project_psd<9>(Eigen::Matrix<double, 9, 9>&);

}  // namespace pf
