#include "core/math/psd.hpp"

#include <Eigen/Eigenvalues>

namespace pf {

template <int N>
void project_psd(Eigen::Matrix<double, N, N>& A) {
  if (!A.allFinite()) return;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> eigen(A);
  if (eigen.eigenvalues()[0] >= 0) return;
  const Eigen::Matrix<double, N, N> Q = eigen.eigenvectors();
  A = Q * eigen.eigenvalues().cwiseMax(0).asDiagonal() * Q.transpose();
  A = (0.5 * (A + A.transpose())).eval();
}

template void project_psd<2>(Eigen::Matrix<double, 2, 2>&);
template void project_psd<3>(Eigen::Matrix<double, 3, 3>&);
template void project_psd<4>(Eigen::Matrix<double, 4, 4>&);
template void project_psd<9>(Eigen::Matrix<double, 9, 9>&);

}  // namespace pf
