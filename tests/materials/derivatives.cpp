// Every law of the registry against differences: a new law is tested by being listed.
#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>

#include "tests/materials/cases.hpp"

using namespace pf;

namespace {

template <int D>
void check_derivatives(const LawInfo& info) {
  const std::unique_ptr<Law<D>> law = make_law<D>(info.name, test::typical_parameters(info));
  for (const Mat<D>& F : test::deformations<D>()) {
    const test::Response<D> here = test::evaluate(*law, F);
    const Mat<D> direction = test::random_matrix<D>(7);
    // Central differences: the error is c h^2, so halving h divides it by 4.
    const auto errors = [&](double h) {
      const auto plus = test::evaluate(*law, Mat<D>(F + h * direction));
      const auto minus = test::evaluate(*law, Mat<D>(F - h * direction));
      const double power = here.P.cwiseProduct(direction).sum();
      Mat<D> dP;
      dP.reshaped() = here.dP * direction.reshaped();
      return std::pair(std::abs((plus.psi - minus.psi) / (2 * h) - power), ((plus.P - minus.P) / (2 * h) - dP).norm());
    };
    const double scale = here.dP.norm();
    const auto coarse = errors(2e-3), fine = errors(1e-3);
    CAPTURE(F);
    for (const auto& [e_coarse, e_fine] :
         {std::pair(coarse.first, fine.first), std::pair(coarse.second, fine.second)}) {
      CHECK(e_fine < 1e-3 * scale);
      if (e_fine > 1e-9 * scale) CHECK(e_coarse / e_fine == doctest::Approx(4).epsilon(0.05));
    }
    CHECK((here.dP - here.dP.transpose()).norm() <= 1e-14 * scale);
  }
}

template <int D>
void check_projection(const LawInfo& info) {
  const std::unique_ptr<Law<D>> law = make_law<D>(info.name, test::typical_parameters(info));
  using Eigensolver = Eigen::SelfAdjointEigenSolver<Tangent<D>>;
  for (const Mat<D>& F : test::deformations<D>()) {
    CAPTURE(F);
    const test::Response<D> here = test::evaluate(*law, F);
    const Eigensolver eigen(here.dP);
    const Tangent<D> nearest =
        eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() * eigen.eigenvectors().transpose();
    CHECK((here.projected - nearest).norm() < 1e-12 * here.dP.norm());
    CHECK(Eigensolver(here.projected).eigenvalues()[0] > -1e-13 * here.dP.norm());
    if (eigen.eigenvalues()[0] > 0) CHECK((here.projected - here.dP).norm() < 1e-13 * here.dP.norm());
  }
}

}  // namespace

TEST_CASE("P is the derivative of psi, and dP that of P, to second order") {
  for (const LawInfo& info : laws()) {
    CAPTURE(info.name);
    check_derivatives<2>(info);
    check_derivatives<3>(info);
  }
}

TEST_CASE("the projected tangent is the nearest positive semi-definite one") {
  for (const LawInfo& info : laws()) {
    CAPTURE(info.name);
    check_projection<2>(info);
    check_projection<3>(info);
  }
}
