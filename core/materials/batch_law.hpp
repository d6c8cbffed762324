// Makes a Law<D> of a small struct that knows psi, P and dP for one F: one virtual call a batch, tight loops inside.
#pragma once

#include <cassert>
#include <cmath>

#include "core/materials/law.hpp"
#include "core/math/psd.hpp"
#include "core/math/small_linalg.hpp"

namespace pf {

/// `Model` offers psi(F), P(F, psi), dP(F, emit), lame and info() as NeoHookean does.
template <class Model, int D>
class BatchLaw final : public Law<D> {
 public:
  explicit BatchLaw(const Model& model) : model_(model), info_(Model::info()) {}

  const LawInfo& info() const override { return info_; }

  void energy(std::span<const Mat<D>> F, std::span<double> psi) const override {
    assert(F.size() == psi.size());
    for (std::size_t p = 0; p < F.size(); ++p) psi[p] = model_.psi(load(F[p]));
  }

  void stress(std::span<const Mat<D>> F, std::span<double> psi, std::span<Mat<D>> P) const override {
    assert(F.size() == psi.size() && F.size() == P.size());
    for (std::size_t p = 0; p < F.size(); ++p) store(model_.P(load(F[p]), psi[p]), P[p]);
  }

  void tangent(std::span<const Mat<D>> F, bool project, std::span<Tangent<D>> dP) const override {
    assert(F.size() == dP.size());
    for (std::size_t p = 0; p < F.size(); ++p) {
      Tangent<D>& A = dP[p];
      model_.dP(load(F[p]), [&A](int row, int column, double value) { A(row, column) = A(column, row) = value; });
      if (project) project_psd(A);
    }
  }

  Mat3 cauchy(const Mat<D>& F) const override {
    Mat3 full = Mat3::Identity(), P;  // plane strain is the 3D motion with F_33 = 1
    full.template topLeftCorner<D, D>() = F;
    double psi = 0;
    store(model_.P(load(full), psi), P);
    return P * full.transpose() / determinant(load(full));
  }

  double wave_speed(double density) const override {
    return std::sqrt((model_.lame.lambda + 2 * model_.lame.mu) / density);
  }

 private:
  template <int N>
  static Square<double, N> load(const Mat<N>& F) {
    Square<double, N> S;
    for (int k = 0; k < N * N; ++k) S.e[k] = F.data()[k];
    return S;
  }
  template <int N>
  static void store(const Square<double, N>& S, Mat<N>& P) {
    for (int k = 0; k < N * N; ++k) P.data()[k] = S.e[k];
  }

  Model model_;
  LawInfo info_;
};

}  // namespace pf
