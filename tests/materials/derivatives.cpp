// Every law of the registry against differences: a new law is tested by being listed.
#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

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

/// (F_n (x) I)
template <int D>
Tangent<D> kronecker(const Mat<D>& F_n) {
  Tangent<D> push = Tangent<D>::Zero();
  for (int b = 0; b < D; ++b)
    for (int e = 0; e < D; ++e) push.template block<D, D>(D * b, D * e) = F_n(b, e) * Mat<D>::Identity();
  return push;
}

/// Particles in slots of `lanes`, `skip` lanes left out in between: places that follow each other and places that do
/// not.
template <int D>
void check_grid_tangent(const Law<D>& law, std::size_t lanes, std::size_t skip, bool project) {
  const std::vector<Mat<D>> all = test::deformations<D>();
  const std::size_t n = all.size() - 1, stride = lanes;
  const std::vector<Mat<D>> F(all.begin(), all.end() - 1), F_n(all.begin() + 1, all.end());
  const float untouched = -7;
  std::vector<float> out(tangent_components<D> * (n + 1) * (skip + 1) * lanes, untouched);
  std::vector<double> weight(n);
  std::vector<float*> place(n);
  std::size_t slot = 0;
  for (std::size_t p = 0; p < n; ++p, slot += 1 + (p % lanes == 0 ? skip : 0)) {
    weight[p] = 1.5 + static_cast<double>(p);
    place[p] = out.data() + slot / lanes * tangent_components<D> * stride + slot % lanes;
  }
  law.grid_tangent(F, F_n, weight, project, place, static_cast<int>(stride));
  std::vector<Tangent<D>> dP(n);
  law.tangent(F, project, dP);
  for (std::size_t p = 0; p < n; ++p) {
    // In single precision, and a projected tangent is lifted by what rounding may take from its eigenvalues.
    constexpr double rounding = 0x1p-24;
    Tangent<D> expected = weight[p] * kronecker(F_n[p]) * dP[p] * kronecker(F_n[p]).transpose();
    if (project) expected.diagonal().array() += rounding * expected.trace();
    Tangent<D> stored;
    for (int row = 0; row < D * D; ++row) {
      for (int column = row; column < D * D; ++column) {
        float& value = place[p][static_cast<std::size_t>(packed_tangent_index<D>(row, column)) * stride];
        const double exact = expected(row, column);
        CHECK(std::abs(value - exact) <= 1.001 * rounding * std::abs(exact) + 1e-13 * expected.norm());
        stored(row, column) = stored(column, row) = value;
        value = untouched;
      }
    }
    if (project) {
      const double least = Eigen::SelfAdjointEigenSolver<Tangent<D>>(stored).eigenvalues().minCoeff();
      CHECK(least >= -1e-14 * stored.norm());
    }
  }
  CHECK(std::all_of(out.begin(), out.end(), [&](float value) { return value == untouched; }));
}

template <int D>
void check_grid_tangent(const LawInfo& info) {
  const std::unique_ptr<Law<D>> law = make_law<D>(info.name, test::typical_parameters(info));
  for (const std::size_t lanes : {4u, 8u})
    for (const std::size_t skip : {0u, 1u})
      for (const bool project : {false, true}) check_grid_tangent<D>(*law, lanes, skip, project);
}

}  // namespace

TEST_CASE("the grid's tangent is the law's, pushed forward by F_n") {
  for (const LawInfo& info : laws()) {
    CAPTURE(info.name);
    check_grid_tangent<2>(info);
    check_grid_tangent<3>(info);
  }
}

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
