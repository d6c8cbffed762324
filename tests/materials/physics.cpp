// What the laws mean: objectivity, rest, small strain, plane strain, known uniaxial values.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "core/materials/lame.hpp"
#include "tests/materials/cases.hpp"

using namespace pf;

namespace {

constexpr double young = 2e5, poisson = 0.3;

/// With `young` and `poisson` above; other parameters, which a law may have besides, at their typical values.
template <int D>
std::unique_ptr<Law<D>> law_of(std::string_view name) {
  std::vector<double> parameters;
  for (const LawParameter& parameter : find_law(name)->parameters)
    parameters.push_back(parameter.key == "young" ? young : parameter.key == "poisson" ? poisson : parameter.typical);
  return make_law<D>(name, parameters);
}

/// 2 mu e + lambda tr(e) I of a displacement gradient H.
template <int D>
Mat<D> linear_stress(const Mat<D>& H) {
  const Lame lame = lame_of(young, poisson);
  return lame.mu * (H + H.transpose()) + lame.lambda * H.trace() * Mat<D>::Identity();
}

template <int D>
void check_objectivity(const LawInfo& info) {
  const auto law = law_of<D>(info.name);
  bool always = true;
  for (const Mat<D>& F : test::deformations<D>()) {
    const Mat<D> R = test::rotation<D>(0.8);
    const auto here = test::evaluate(*law, F), turned = test::evaluate(*law, Mat<D>(R * F));
    const bool same_psi = std::abs(turned.psi - here.psi) <= 1e-14 * young * F.squaredNorm() + 1e-13 * here.psi;
    const bool same_P = (turned.P - R * here.P).norm() <= 1e-13 * here.dP.norm() * F.norm();
    if (info.objective) CHECK((same_psi && same_P));
    always = always && same_psi && same_P;
  }
  CHECK(always == info.objective);
}

template <int D>
void check_rest(const LawInfo& info) {
  const auto law = law_of<D>(info.name);
  const auto rest = test::evaluate(*law, Mat<D>(Mat<D>::Identity()));
  CHECK(rest.psi == 0);
  CHECK(rest.P.norm() <= 1e-15 * young);
  const auto turned = test::evaluate(*law, test::rotation<D>(2.2));
  if (info.objective) {
    CHECK(std::abs(turned.psi) <= 1e-30 * young);
    CHECK(turned.P.norm() <= 1e-14 * young);
  } else {
    CHECK(turned.psi > 0.1 * young);  // rotation counts as strain
  }
}

/// A deformation of the plane, and of space with F_33 = 1.
void check_plane_strain(const LawInfo& info) {
  const auto flat = law_of<2>(info.name);
  const auto solid = law_of<3>(info.name);
  for (const Mat<2>& F : test::deformations<2>()) {
    Mat3 F_solid = Mat3::Identity();
    F_solid.topLeftCorner<2, 2>() = F;
    const auto in_plane = test::evaluate(*flat, F);
    const auto in_space = test::evaluate(*solid, F_solid);
    const double scale = in_space.dP.norm();
    CHECK(std::abs(in_plane.psi - in_space.psi) <= 1e-14 * scale);
    CHECK((in_plane.P - in_space.P.topLeftCorner<2, 2>()).norm() <= 1e-14 * scale);
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) {
        const double expected = in_space.dP(row % 2 + 3 * (row / 2), column % 2 + 3 * (column / 2));
        CHECK(std::abs(in_plane.dP(row, column) - expected) <= 1e-14 * scale);
      }
    }
    const Mat3 sigma = flat->cauchy(F);
    CHECK((sigma - solid->cauchy(F_solid)).norm() == 0);
    CHECK((sigma - in_space.P * F_solid.transpose() / F.determinant()).norm() <= 1e-13 * scale);
    CHECK(sigma(0, 2) == doctest::Approx(0));
    if (info.objective) CHECK((sigma - sigma.transpose()).norm() <= 1e-13 * scale);
  }
}

template <int D>
void check_small_strain(const LawInfo& info) {
  const auto law = law_of<D>(info.name);
  const auto rest = test::evaluate(*law, Mat<D>(Mat<D>::Identity()));
  for (unsigned seed = 1; seed < 5; ++seed) {
    const Mat<D> direction = test::random_matrix<D>(seed);
    Mat<D> slope;
    slope.reshaped() = rest.dP * direction.reshaped();
    CHECK((slope - linear_stress<D>(direction)).norm() <= 1e-14 * young * direction.norm());
    for (const double strain : {1e-4, 1e-6, 1e-8, 1e-10}) {
      const Mat<D> F = Mat<D>::Identity() + strain * direction;
      const Mat<D> H = F - Mat<D>::Identity();  // exact: what F holds after rounding
      const Mat<D> expected = linear_stress<D>(H);
      const auto here = test::evaluate(*law, F);
      // Linear theory is off by O(strain), rounding of F by 1e-16/strain.
      const double allowed = 10 * strain + 3e-15 / strain;
      CAPTURE(strain);
      CHECK((here.P - expected).norm() <= allowed * expected.norm());
      const double psi = 0.5 * expected.cwiseProduct(H).sum();
      CHECK(std::abs(here.psi - psi) <= allowed * psi);
      CHECK(std::abs(test::energy(*law, F) - here.psi) <= 3e-15 / strain * psi);
    }
  }
}

}  // namespace

TEST_CASE("the energy does not see a rotation where the law says so, and sees it where it does not") {
  for (const LawInfo& info : laws()) {
    CAPTURE(info.name);
    check_objectivity<2>(info);
    check_objectivity<3>(info);
  }
}

TEST_CASE("a body at rest is free of stress and energy") {
  for (const LawInfo& info : laws()) {
    CAPTURE(info.name);
    check_rest<2>(info);
    check_rest<3>(info);
  }
}

TEST_CASE("2D is plane strain: the 3D law with F_33 = 1, sigma_zz included") {
  for (const LawInfo& info : laws()) {
    CAPTURE(info.name);
    check_plane_strain(info);
  }
}

TEST_CASE("at small strain every law is linear elasticity with its E and nu, down to what F can hold") {
  for (const LawInfo& info : laws()) {
    CAPTURE(info.name);
    check_small_strain<2>(info);
    check_small_strain<3>(info);
  }
}

TEST_CASE("pressure waves: sqrt((lambda + 2 mu)/rho) = sqrt(E (1 - nu)/((1 + nu)(1 - 2 nu) rho))") {
  const double speed = std::sqrt(young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)) / 800);
  for (const LawInfo& info : laws()) {
    CHECK(law_of<2>(info.name)->wave_speed(800) == doctest::Approx(speed).epsilon(1e-14));
    CHECK(law_of<3>(info.name)->wave_speed(800) == doctest::Approx(speed).epsilon(1e-14));
  }
}

TEST_CASE("uniaxial strain F = diag(s, 1, 1): P_11 by hand") {
  const Lame lame = lame_of(young, poisson);
  for (const double s : {0.5, 0.9, 1.0, 1.4, 3.0}) {
    const double e = s - 1, green = (s * s - 1) / 2, modulus = lame.lambda + 2 * lame.mu;
    const std::pair<std::string_view, double> expected[] = {
        {"linear_elastic", modulus * e},
        {"st_venant_kirchhoff", s * modulus * green},
        {"neo_hookean", lame.mu * (s - 1 / s) + lame.lambda * std::log(s) / s},
        {"fixed_corotated", modulus * e},
        {"hencky", modulus * std::log(s) / s}};
    for (const auto& [name, P] : expected) {
      CAPTURE(name);
      CAPTURE(s);
      const Mat3 F = Vec3(s, 1, 1).asDiagonal();
      CHECK(std::abs(test::evaluate(*law_of<3>(name), F).P(0, 0) - P) <= 1e-14 * modulus * s);
    }
  }
}

TEST_CASE("uniaxial stress: each law keeps the meaning of E and nu in its own measure of strain") {
  for (const double s : {0.8, 1.3}) {
    const double lateral_hencky = std::pow(s, -poisson);
    const Mat3 hencky = law_of<3>("hencky")->cauchy(Vec3(s, lateral_hencky, lateral_hencky).asDiagonal());
    const double J = s * lateral_hencky * lateral_hencky;
    CHECK(hencky(0, 0) == doctest::Approx(young * std::log(s) / J).epsilon(1e-12));
    CHECK(std::abs(hencky(1, 1)) < 1e-12 * young);

    const double green = (s * s - 1) / 2, lateral = std::sqrt(1 - 2 * poisson * green);
    const auto kirchhoff =
        test::evaluate(*law_of<3>("st_venant_kirchhoff"), Mat3(Vec3(s, lateral, lateral).asDiagonal()));
    CHECK(kirchhoff.P(0, 0) == doctest::Approx(s * young * green).epsilon(1e-12));
    CHECK(std::abs(kirchhoff.P(1, 1)) < 1e-12 * young);
  }
}

TEST_CASE("simple shear by g: neo-Hookean sigma_12 = mu g, sigma_11 - sigma_22 = mu g^2") {
  const double mu = lame_of(young, poisson).mu, g = 0.7;
  Mat<2> F = Mat<2>::Identity();
  F(0, 1) = g;
  const Mat3 sigma = law_of<2>("neo_hookean")->cauchy(F);
  CHECK(sigma(0, 1) == doctest::Approx(mu * g).epsilon(1e-13));
  CHECK(sigma(0, 0) - sigma(1, 1) == doctest::Approx(mu * g * g).epsilon(1e-13));
  CHECK(std::abs(sigma(2, 2)) < 1e-13 * mu);
}
