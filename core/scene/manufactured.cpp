#include "core/scene/manufactured.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace pf {
namespace {

constexpr std::size_t batch = 32;  ///< points a call of the law

template <int D>
Vec<D> divergence(const Tangent<D>& dP, const std::array<Mat<D>, D>& gradient) {
  Vec<D> div = Vec<D>::Zero();
  for (int a = 0; a < D; ++a)
    for (int A = 0; A < D; ++A)
      for (int b = 0; b < D; ++b)
        for (int B = 0; B < D; ++B) div[a] += dP(a + D * A, b + D * B) * gradient[static_cast<std::size_t>(b)](A, B);
  return div;
}

}  // namespace

template <int D>
void ManufacturedLoads<D>::body_acceleration(std::span<const Vec<D>> X, double t, std::span<Vec<D>> b) const {
  assert(X.size() == b.size());
  std::array<MotionPoint<D>, batch> points;
  std::array<Mat<D>, batch> F;
  std::array<Tangent<D>, batch> dP;
  for (std::size_t begin = 0; begin < X.size(); begin += batch) {
    const std::size_t n = std::min(batch, X.size() - begin);
    for (std::size_t i = 0; i < n; ++i) {
      points[i] = motion_.at(X[begin + i], t);
      F[i] = points[i].F;
    }
    law_.tangent(std::span<const Mat<D>>(F).first(n), false, std::span<Tangent<D>>(dP).first(n));
    for (std::size_t i = 0; i < n; ++i)
      b[begin + i] = points[i].acceleration - divergence<D>(dP[i], points[i].gradient) / density_ - gravity_;
  }
}

template <int D>
void ManufacturedLoads<D>::traction(std::span<const Vec<D>> X, std::span<const Vec<D>> N, double t,
                                    std::span<Vec<D>> traction) const {
  assert(X.size() == N.size() && X.size() == traction.size());
  std::array<Mat<D>, batch> F, P;
  std::array<double, batch> psi;
  for (std::size_t begin = 0; begin < X.size(); begin += batch) {
    const std::size_t n = std::min(batch, X.size() - begin);
    for (std::size_t i = 0; i < n; ++i) F[i] = motion_.F(X[begin + i], t);
    law_.stress(std::span<const Mat<D>>(F).first(n), std::span<double>(psi).first(n), std::span<Mat<D>>(P).first(n));
    for (std::size_t i = 0; i < n; ++i) traction[begin + i] = P[i] * N[begin + i];
  }
}

template class ManufacturedLoads<2>;
template class ManufacturedLoads<3>;

}  // namespace pf
