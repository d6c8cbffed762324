// Makes a Law<D> of a law's struct (see evaluate.hpp): one virtual call a batch, eight particles at a time inside.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/materials/evaluate.hpp"
#include "core/materials/law.hpp"

namespace pf {

/// A particle's result depends on its own F only, to the bit, wherever it stands in a batch of whatever length.
template <class Model, int D>
class BatchLaw final : public Law<D> {
 public:
  explicit BatchLaw(const Model& model) : model_(model), info_(Model::info()) {}

  const LawInfo& info() const override { return info_; }

  void energy(std::span<const Mat<D>> F, std::span<double> psi) const override {
    assert(F.size() == psi.size());
    for_packs(F, [&](const Square<Pack, D>& F_pack, std::size_t first, std::size_t count) {
      store(psi_of(model_, F_pack), psi.subspan(first, count));
    });
  }

  void stress(std::span<const Mat<D>> F, std::span<double> psi, std::span<Mat<D>> P) const override {
    assert(F.size() == psi.size() && F.size() == P.size());
    for_packs(F, [&](const Square<Pack, D>& F_pack, std::size_t first, std::size_t count) {
      Pack psi_pack;
      const Square<Pack, D> P_pack = P_of(model_, F_pack, psi_pack);
      store(psi_pack, psi.subspan(first, count));
      store<D * D>(P_pack.e, P.subspan(first, count));
    });
  }

  void tangent(std::span<const Mat<D>> F, bool project, std::span<Tangent<D>> dP) const override {
    assert(F.size() == dP.size());
    if (project) {
      tangent_packs<true>(F, dP);
    } else {
      tangent_packs<false>(F, dP);
    }
  }

  Mat3 cauchy(const Mat<D>& F) const override {
    Mat3 full = Mat3::Identity(), P;  // plane strain is the 3D motion with F_33 = 1
    full.template topLeftCorner<D, D>() = F;
    Square<double, 3> F_full;
    std::copy_n(full.data(), 9, F_full.e);
    double psi = 0;
    std::copy_n(P_of(model_, F_full, psi).e, 9, P.data());
    return P * full.transpose() / determinant(F_full);
  }

  double wave_speed(double density) const override {
    return std::sqrt((model_.lame.lambda + 2 * model_.lame.mu) / density);
  }

 private:
  static constexpr std::size_t width = Lanes<Pack>::count;

  /// Calls use(F of eight particles, index of the first, how many of them are meant); the rest repeats the last.
  /// One place calls it: two copies of the inlined formula might be contracted to FMA in two ways.
  template <class Use>
  static void for_packs(std::span<const Mat<D>> F, const Use& use) {
    Square<Pack, D> F_pack;
    Mat<D> padded[width];
    for (std::size_t p = 0; p < F.size(); p += width) {
      const std::size_t count = std::min(width, F.size() - p);
      const Mat<D>* first = &F[p];
      if (count < width) {
        for (std::size_t lane = 0; lane < width; ++lane) padded[lane] = F[std::min(p + lane, F.size() - 1)];
        first = padded;
      }
      load_records<D * D>(first->data(), F_pack.e);
      use(F_pack, p, count);
    }
  }

  static void store(const Pack& values, std::span<double> out) {
    for (std::size_t lane = 0; lane < out.size(); ++lane) out[lane] = values[static_cast<int>(lane)];
  }

  template <int size, class Record>
  static void store(const Pack* values, std::span<Record> out) {
    static_assert(sizeof(Record) == size * sizeof(double));
    if (out.size() == width) {
      store_records<size>(values, out[0].data());
      return;
    }
    Record padded[width];
    store_records<size>(values, padded[0].data());
    std::copy_n(padded, out.size(), out.begin());
  }

  template <bool project>
  void tangent_packs(std::span<const Mat<D>> F, std::span<Tangent<D>> dP) const {
    for_packs(F, [&](const Square<Pack, D>& F_pack, std::size_t first, std::size_t count) {
      UpperTangent<Pack, D> A;
      dP_of<project>(model_, F_pack, A);
      for (int column = 0; column < D * D; ++column)
        for (int row = 0; row < column; ++row) A(column, row) = A(row, column);
      store<D * D * D * D>(A.e, dP.subspan(first, count));
    });
  }

  Model model_;
  LawInfo info_;
};

}  // namespace pf
