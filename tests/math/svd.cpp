#include "core/math/svd.hpp"

#include <doctest/doctest.h>

#include <Eigen/SVD>
#include <limits>

#include "core/math/polar.hpp"
#include "tests/math/matrices.hpp"

using namespace pf;

namespace {

template <int D>
Svd<double, D> lane_of(const Svd<Pack, D>& svd, int lane) {
  Svd<double, D> result{test::lane(svd.U, lane), test::lane(svd.V, lane), {}};
  for (int i = 0; i < D; ++i) result.s[i] = svd.s[i][lane];
  return result;
}

template <int D>
void check_svd(const Mat<D>& F, const Svd<double, D>& result) {
  const Mat<D> U = test::eigen(result.U), V = test::eigen(result.V);
  const Vec<D> s(result.s);
  const double norm = F.norm();
  CAPTURE(F);
  CAPTURE(s);
  CHECK((U.transpose() * U - Mat<D>::Identity()).norm() < 4e-15);
  CHECK((V.transpose() * V - Mat<D>::Identity()).norm() < 4e-15);
  CHECK(U.determinant() == doctest::Approx(1));
  CHECK(V.determinant() == doctest::Approx(1));
  CHECK((U * s.asDiagonal() * V.transpose() - F).norm() <= 4e-15 * norm);
  const Vec<D> expected = Eigen::JacobiSVD<Mat<D>>(F).singularValues();
  CHECK((s.cwiseAbs() - expected).norm() <= 4e-15 * norm);
  for (int i = 0; i + 1 < D; ++i) {
    CHECK(s[i] >= 0);
    CHECK(s[i] - std::abs(s[i + 1]) >= -1e-15 * norm);
  }
  // The sign of the last one is that of the determinant, as far as that is above rounding.
  const Mat<D> unit = norm > 0 ? Mat<D>(F / norm) : F;
  if (std::abs(unit.determinant()) > 1e-15) CHECK((s[D - 1] < 0) == (unit.determinant() < 0));
}

template <int D>
void check_all() {
  const std::vector<Mat<D>> list = test::hard_matrices<D>();
  for (std::size_t first = 0; first < list.size(); first += 8) {
    const Svd<Pack, D> packed = svd(test::pack(list, first));
    for (int lane = 0; lane < 8; ++lane) {
      const Mat<D>& F = list[(first + static_cast<std::size_t>(lane)) % list.size()];
      check_svd(F, lane_of(packed, lane));
      check_svd(F, svd(test::square(F)));
    }
  }
}

}  // namespace

TEST_CASE("singular value decomposition: rotations, order, sign and accuracy on easy and degenerate matrices") {
  check_all<2>();
  check_all<3>();
}

TEST_CASE("singular values far below the largest keep their digits where the entries do") {
  const Mat3 F = Vec3(1e-9, 1, 1e-30).asDiagonal();
  const Svd<double, 3> result = svd(test::square(F));
  CHECK(result.s[1] == doctest::Approx(1e-9).epsilon(1e-14));
  CHECK(result.s[2] == doctest::Approx(1e-30).epsilon(1e-14));
  const Svd<double, 2> flat = svd(test::square(Mat<2>(Vec<2>(1e-30, 7).asDiagonal())));
  CHECK(flat.s[1] == doctest::Approx(1e-30).epsilon(1e-14));
}

TEST_CASE("NaN and infinity end the decomposition, show in the singular values and leave other lanes alone") {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (int entry = 0; entry < 9; ++entry) {
      std::vector<Mat3> list(8, Mat3(Vec3(3, 2, 1).asDiagonal()));
      list[2].data()[entry] = bad;
      const Svd<Pack, 3> packed = svd(test::pack(list, 0));
      const Svd<double, 3> broken = lane_of(packed, 2);
      CHECK((std::isnan(broken.s[0]) || std::isnan(broken.s[1]) || std::isnan(broken.s[2])));
      check_svd(list[3], lane_of(packed, 3));
      if (entry < 4) {
        Mat<2> F = Mat<2>::Identity();
        F.data()[entry] = bad;
        const Svd<double, 2> flat = svd(test::square(F));
        CHECK((std::isnan(flat.s[0]) || std::isnan(flat.s[1])));
      }
    }
  }
}

TEST_CASE_TEMPLATE("polar decomposition gives a rotation and a symmetric stretch", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
  constexpr int D = Dimension::value;
  for (const Mat<D>& F : test::hard_matrices<D>()) {
    const Polar<double, D> result = polar(test::square(F));
    const Mat<D> R = test::eigen(result.R), S = test::eigen(result.S);
    CHECK((R.transpose() * R - Mat<D>::Identity()).norm() < 8e-15);
    CHECK(R.determinant() == doctest::Approx(1));
    CHECK((S - S.transpose()).norm() <= 1e-15 * F.norm());
    CHECK((R * S - F).norm() <= 8e-15 * F.norm());
  }
}
