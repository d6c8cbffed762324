// Makes a Law<D> of a law's struct (see evaluate.hpp): one virtual call a batch, eight particles at a time inside.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

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

  void grid_tangent(std::span<const Mat<D>> F, std::span<const Mat<D>> F_n, std::span<const double> weight,
                    bool project, std::span<float* const> place, int stride) const override {
    assert(F.size() == F_n.size() && F.size() == weight.size() && F.size() == place.size());
    for_packs(F, [&](const Square<Pack, D>& F_pack, std::size_t first, std::size_t count) {
      const Square<Pack, D> F_n_pack = load(F_n.subspan(first, count));
      UpperTangent<Pack, D> A;
      if (project) {
        grid_dP_of<true>(model_, F_pack, F_n_pack, A);
      } else {
        grid_dP_of<false>(model_, F_pack, F_n_pack, A);
      }
      Pack scale{};
      for (std::size_t lane = 0; lane < count; ++lane) scale[static_cast<int>(lane)] = weight[first + lane];
      for (int column = 0; column < D * D; ++column)
        for (int row = 0; row <= column; ++row) A(row, column) *= scale;
      // Rounding moves a number by 2^-24 of itself at most, hence an eigenvalue of a positive semi-definite matrix by
      // 2^-24 of the trace.
      if (project) {
        Pack trace{};
        for (int k = 0; k < D * D; ++k) trace += A(k, k);
        for (int k = 0; k < D * D; ++k) A(k, k) += 0x1p-24 * trace;
      }
      store_tangent(A, place.subspan(first, count), stride);
    });
  }

  void cauchy(std::span<const Mat<D>> F, std::span<Mat3> sigma) const override {
    assert(F.size() == sigma.size());
    for_packs(F, [&](const Square<Pack, D>& F_pack, std::size_t first, std::size_t count) {
      Square<Pack, 3> F_full = identity_of<Pack, 3>(), sigma_pack;  // plane strain is the 3D motion with F_33 = 1
      for (int b = 0; b < D; ++b)
        for (int a = 0; a < D; ++a) F_full(a, b) = F_pack(a, b);
      Pack psi;
      const Square<Pack, 3> P = P_of(model_, F_full, psi);
      const Pack inverse_J = 1.0 / determinant(F_full);
      for (int b = 0; b < 3; ++b)
        for (int a = 0; a < 3; ++a)
          sigma_pack(a, b) = inverse_J * (P(a, 0) * F_full(b, 0) + P(a, 1) * F_full(b, 1) + P(a, 2) * F_full(b, 2));
      store<9>(sigma_pack.e, sigma.subspan(first, count));
    });
  }
  using Law<D>::cauchy;

  double wave_speed(double density) const override {
    return std::sqrt((model_.lame.lambda + 2 * model_.lame.mu) / density);
  }
  double shear_modulus() const override { return model_.lame.mu; }

 private:
  static constexpr std::size_t width = Lanes<Pack>::count;

  /// Up to eight particles; missing ones repeat the last.
  static Square<Pack, D> load(std::span<const Mat<D>> F) {
    Square<Pack, D> F_pack;
    if (F.size() == width) {
      load_records<D * D>(F[0].data(), F_pack.e);
      return F_pack;
    }
    Mat<D> padded[width];
    for (std::size_t lane = 0; lane < width; ++lane) padded[lane] = F[std::min(lane, F.size() - 1)];
    load_records<D * D>(padded[0].data(), F_pack.e);
    return F_pack;
  }

  /// Calls use(F of eight particles, index of the first, how many of them are meant). One place calls it: two copies
  /// of the inlined formula might be contracted to FMA in two ways.
  template <class Use>
  static void for_packs(std::span<const Mat<D>> F, const Use& use) {
    for (std::size_t p = 0; p < F.size(); p += width) {
      const std::size_t count = std::min(width, F.size() - p);
      use(load(F.subspan(p, count)), p, count);
    }
  }

  static void store(const Pack& values, std::span<double> out) {
    if (out.size() == width) {
      std::memcpy(out.data(), &values, sizeof(Pack));
    } else {
      for (std::size_t lane = 0; lane < out.size(); ++lane) out[lane] = values[static_cast<int>(lane)];
    }
  }

  /// A to the particles' places: whole packs or halves of one where places allow, else number by number.
  static void store_tangent(const UpperTangent<Pack, D>& A, std::span<float* const> place, int stride) {
    typedef float Singles __attribute__((vector_size(width * sizeof(float))));
    const auto follow = [place](std::size_t first, std::size_t count) {
      for (std::size_t lane = 1; lane < count; ++lane)
        if (place[first + lane] != place[first] + lane) return false;
      return true;
    };
    const auto each_component = [&](const auto& write) {
      for (int row = 0; row < D * D; ++row)
        for (int column = row; column < D * D; ++column)
          write(__builtin_convertvector(A(row, column), Singles), packed_tangent_index<D>(row, column) * stride);
    };
    constexpr std::size_t half = width / 2;
    if (place.size() == width && follow(0, width)) {
      each_component([&](const Singles& x, int at) { std::memcpy(place[0] + at, &x, sizeof x); });
    } else if (place.size() == width && follow(0, half) && follow(half, half)) {
      each_component([&](const Singles& x, int at) {
        const float* values = reinterpret_cast<const float*>(&x);
        std::memcpy(place[0] + at, values, sizeof x / 2);
        std::memcpy(place[half] + at, values + half, sizeof x / 2);
      });
    } else {
      each_component([&](const Singles& x, int at) {
        for (std::size_t lane = 0; lane < place.size(); ++lane) place[lane][at] = x[static_cast<int>(lane)];
      });
    }
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
