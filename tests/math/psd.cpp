#include "core/math/psd.hpp"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>

#include "tests/math/matrices.hpp"

using namespace pf;

namespace {

template <int D>
Mat<D> nearest_psd(const Mat<D>& A) {
  const Eigen::SelfAdjointEigenSolver<Mat<D>> solver(A);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).asDiagonal() * solver.eigenvectors().transpose();
}

template <int D>
void check_clamp() {
  for (const Mat<D>& M : test::hard_matrices<D>()) {
    // Squares must not overflow: tangents are stiffnesses, far from the ends of the range.
    if (M.norm() > 1e50 || (M.norm() < 1e-50 && M.norm() > 0)) continue;
    for (const Mat<D>& A : {Mat<D>(M + M.transpose()), Mat<D>(M * M.transpose()), Mat<D>(-M * M.transpose())}) {
      Square<double, D> clamped = test::square(A);
      clamp_psd(clamped);
      CAPTURE(A);
      CHECK((test::eigen(clamped) - nearest_psd(A)).norm() <= 2e-14 * A.norm());
      if (Eigen::SelfAdjointEigenSolver<Mat<D>>(A).eigenvalues()[0] > 1e-7 * A.norm()) CHECK(test::eigen(clamped) == A);
    }
  }
}

}  // namespace

TEST_CASE("clamping gives the nearest positive semi-definite matrix and leaves definite ones untouched") {
  check_clamp<2>();
  check_clamp<3>();
}

TEST_CASE("clamping works lane by lane") {
  std::vector<Mat3> list;
  for (const Mat3& M : test::hard_matrices<3>())
    if (M.norm() < 1e10 && list.size() < 64) list.push_back(M + M.transpose());
  for (std::size_t first = 0; first < list.size(); first += 8) {
    Square<Pack, 3> packed = test::pack(list, first);
    clamp_psd(packed);
    for (int lane = 0; lane < 8; ++lane) {
      const Mat3& A = list[(first + static_cast<std::size_t>(lane)) % list.size()];
      CHECK((test::eigen(test::lane(packed, lane)) - nearest_psd(A)).norm() <= 2e-14 * A.norm());
    }
  }
}

TEST_CASE("a diagonalised symmetric matrix is put together again by its eigenvectors") {
  for (const Mat3& M : test::hard_matrices<3>()) {
    if (M.norm() > 1e140 || M.norm() < 1e-140) continue;
    const Mat3 A = M + M.transpose();
    Square<double, 3> values = test::square(A);
    const Mat3 Q = test::eigen(diagonalise(values));
    const Vec3 eigenvalues = test::eigen(values).diagonal();
    CAPTURE(A);
    CHECK((Q.transpose() * Q - Mat3::Identity()).norm() < 4e-15);
    CHECK((Q * eigenvalues.asDiagonal() * Q.transpose() - A).norm() <= 6e-15 * A.norm());
  }
}

TEST_CASE("NaN stays visible after clamping and does not hang") {
  for (int entry = 0; entry < 9; ++entry) {
    Square<double, 3> A = identity_of<double, 3>();
    A.e[entry] = std::numeric_limits<double>::quiet_NaN();
    A(entry / 3, entry % 3) = A.e[entry];
    clamp_psd(A);
    CHECK(!test::eigen(A).allFinite());
  }
}
