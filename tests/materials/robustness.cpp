// Inverted, extreme and broken input; tiny strain; batches of any length.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/materials/lame.hpp"
#include "tests/materials/cases.hpp"

using namespace pf;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <int D>
std::unique_ptr<Law<D>> typical_law(const LawInfo& info) {
  return make_law<D>(info.name, test::typical_parameters(info));
}

template <int D>
void check_barrier(const LawInfo& info) {
  const auto law = typical_law<D>(info);
  Vec<D> s = Vec<D>::Ones();
  double last = 0;
  for (const double smallest : {1e-1, 1e-3, 1e-6, 1e-12, 1e-100}) {
    s[0] = smallest;
    const double psi = test::energy(*law, test::stretched<D>(s, 0, 0));
    CHECK(std::isfinite(psi));
    if (info.barrier_at_zero) CHECK(psi > last);
    last = psi;
  }
  for (const double smallest : {0.0, -1e-9, -0.5, -2.0}) {
    s[0] = smallest;
    const Mat<D> F = test::stretched<D>(s, 0, 0);  // no rotation: det F = smallest, exactly
    const auto response = test::evaluate(*law, F);
    CAPTURE(smallest);
    if (info.barrier_at_zero) {
      CHECK(response.psi == infinity);
      CHECK(test::energy(*law, F) == infinity);
    } else {
      CHECK(std::isfinite(response.psi));
      CHECK(response.P.allFinite());
      CHECK(response.projected.allFinite());
    }
  }
}

template <int D>
void check_broken_input(const LawInfo& info) {
  const auto law = typical_law<D>(info);
  const Mat<D> good = test::deformations<D>()[6];
  const auto alone = test::evaluate(*law, good);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity, 1e300}) {
    for (int entry = 0; entry < D * D; ++entry) {
      std::vector<Mat<D>> F(8, good), P(8);
      std::vector<double> psi(8);
      std::vector<Tangent<D>> dP(8), projected(8);
      F[3].data()[entry] = bad;
      law->stress(F, psi, P);
      law->tangent(F, false, dP);
      law->tangent(F, true, projected);
      if (!std::isfinite(bad)) CHECK(!std::isfinite(psi[3]));  // no line search takes it
      CHECK(psi[4] == alone.psi);
      CHECK(P[2] == alone.P);
      CHECK(dP[2] == alone.dP);
      CHECK(projected[4] == alone.projected);
    }
  }
}

template <int D>
void check_batches(const LawInfo& info) {
  const auto law = typical_law<D>(info);
  const std::vector<Mat<D>> all = test::deformations<D>();
  for (std::size_t count = 0; count <= all.size(); ++count) {
    for (std::size_t first = 0; first + count <= all.size(); first += 3) {
      const std::span<const Mat<D>> F(all.data() + first, count);
      std::vector<double> psi(count), energy(count);
      std::vector<Mat<D>> P(count);
      std::vector<Tangent<D>> dP(count), projected(count);
      std::vector<Mat3> sigma(count);
      law->cauchy(F, sigma);
      law->energy(F, energy);
      law->stress(F, psi, P);
      law->tangent(F, false, dP);
      law->tangent(F, true, projected);
      for (std::size_t p = 0; p < count; ++p) {
        const auto alone = test::evaluate(*law, F[p]);
        CHECK(sigma[p] == law->cauchy(F[p]));
        CHECK((psi[p] == alone.psi && energy[p] == test::energy(*law, F[p]) && P[p] == alone.P && dP[p] == alone.dP &&
               projected[p] == alone.projected));
      }
    }
  }
}

}  // namespace

TEST_CASE("laws with a barrier have infinite energy at J <= 0, the others stay finite") {
  for (const LawInfo& info : laws()) {
    CAPTURE(info.name);
    check_barrier<2>(info);
    check_barrier<3>(info);
  }
}

TEST_CASE("NaN, infinity and overflow neither hang nor reach other particles of the batch") {
  for (const LawInfo& info : laws()) {
    CAPTURE(info.name);
    check_broken_input<2>(info);
    check_broken_input<3>(info);
  }
}

TEST_CASE("a particle's result is the same to the bit wherever it stands in a batch") {
  for (const LawInfo& info : laws()) {
    CAPTURE(info.name);
    check_batches<2>(info);
    check_batches<3>(info);
  }
}

TEST_CASE("neo-Hookean near F = I: as exact as F itself, against long double") {
  const Lame lame = lame_of(1e5, 0.3);
  const auto law = make_law<3>("neo_hookean", std::vector<double>{1e5, 0.3});
  using Wide = Eigen::Matrix<long double, 3, 3>;
  for (double strain = 1e-12; strain < 1e-2; strain *= 7) {
    const Mat3 F = Mat3::Identity() + strain * test::random_matrix<3>(3);
    const auto here = test::evaluate(*law, F);
    // The same formulae in H = F - I, so that the reference does not cancel: F - F^-T = F^-T (H + H^T + H^T H).
    const Wide W = F.cast<long double>(), H = W - Wide::Identity();
    Wide cofactor;
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        const int a1 = (a + 1) % 3, a2 = (a + 2) % 3, b1 = (b + 1) % 3, b2 = (b + 2) % 3;
        cofactor(a, b) = W(a1, b1) * W(a2, b2) - W(a1, b2) * W(a2, b1);
      }
    }
    const Wide G = H + H.transpose() + H.transpose() * H;
    const long double minors = G(0, 0) * G(1, 1) - G(0, 1) * G(0, 1) + G(1, 1) * G(2, 2) - G(1, 2) * G(1, 2) +
                               G(2, 2) * G(0, 0) - G(0, 2) * G(0, 2) + G.determinant();
    const long double J = W.cwiseProduct(cofactor).sum() / 3, ln_J = std::log1p(G.trace() + minors) / 2;
    const Wide P = cofactor / J * (lame.mu * G + lame.lambda * ln_J * Wide::Identity());
    CAPTURE(strain);
    CHECK((here.P.cast<long double>() - P).norm() <= 3e-15L * P.norm());
    if (strain > 1e-6) {  // below, the reference for psi would cancel even in long double
      const long double psi = lame.mu / 2 * (G.trace() - 2 * ln_J) + lame.lambda / 2 * ln_J * ln_J;
      CHECK(std::abs(here.psi / static_cast<double>(psi) - 1) <= 1e-19 / strain / strain + 3e-15);
    }
  }
}

TEST_CASE("energies of neighbouring tiny strains differ by what they should: what a line search compares") {
  for (const LawInfo& info : laws()) {
    CAPTURE(info.name);
    const auto law = typical_law<3>(info);
    const Mat3 base = info.objective ? test::rotation<3>(0) : Mat3::Identity();
    for (const double strain : {1e-3, 1e-5, 1e-6}) {
      const Mat3 direction = test::random_matrix<3>(11);
      const double psi_1 = test::energy(*law, Mat3(base * (Mat3::Identity() + strain * direction)));
      const double psi_2 = test::energy(*law, Mat3(base * (Mat3::Identity() + 1.0001 * strain * direction)));
      // psi is quadratic there up to O(strain); F's rounding changes it by 1e-16/strain.
      CHECK((psi_2 / psi_1 - 1) / 2.0001e-4 == doctest::Approx(1).epsilon(1e-2 + 1e-11 / strain));
    }
  }
}

TEST_CASE("rotated tiny strain: the energy keeps second order in the strain, not rounding of order mu") {
  for (const LawInfo& info : laws()) {
    if (!info.objective) continue;
    CAPTURE(info.name);
    const auto law = typical_law<3>(info);
    const Mat3 H = 1e-7 * test::random_matrix<3>(11);
    const double plain = test::energy(*law, Mat3(Mat3::Identity() + H));
    const double turned = test::energy(*law, Mat3(test::rotation<3>(1.3) * (Mat3::Identity() + H)));
    CHECK(turned / plain == doctest::Approx(1).epsilon(1e-7));
  }
}

TEST_CASE("the registry: names are unique, unknown ones and wrong counts are refused") {
  for (const LawInfo& info : laws()) {
    CHECK(find_law(info.name) == &info);
    CHECK(!info.parameters.empty());
    CHECK(!info.about.empty());
    for (const LawParameter& parameter : info.parameters) {
      CHECK(parameter.typical > parameter.min);
      CHECK(parameter.typical < parameter.max);
    }
    CHECK(typical_law<2>(info)->info().name == info.name);
    CHECK_THROWS_AS(make_law<2>(info.name, {}), std::invalid_argument);
  }
  for (const std::string_view name :
       {"linear_elastic", "st_venant_kirchhoff", "neo_hookean", "fixed_corotated", "hencky"})
    CHECK(find_law(name) != nullptr);
  CHECK(find_law("rubber") == nullptr);
  CHECK_THROWS_AS(make_law<3>("rubber", {}), std::invalid_argument);
}
