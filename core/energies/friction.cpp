#include "core/energies/friction.hpp"

#include <cmath>

namespace pf {

namespace {

template <int D>
Vec<D> slip_at(const NodeConstraint<D>& c, const Vector& u) {
  return rub_slip(c, Vec<D>(u.segment<D>(c.node * D)));
}

}  // namespace

template <int D>
double Friction<D>::value(const Vector& u) {
  double E = 0;
  for (const NodeConstraint<D>& c : set_.constrained)
    if (c.rub_bound > 0) E += c.rub_bound * slip_at(c, u).norm();
  return E;
}

template <int D>
double Friction<D>::gradient(const Vector& u, Vector& g, Vector& magnitude) {
  for (const NodeConstraint<D>& c : set_.constrained) {
    if (!(c.rub_bound > 0)) continue;
    const Vec<D> t = slip_at(c, u);
    const double length = t.norm();
    if (!at_rest(c, t, set_.rounding)) g.segment<D>(c.node * D) += c.rub_bound / length * t;
    magnitude[c.node] += c.rub_bound;
  }
  return value(u);
}

template <int D>
void Friction<D>::prepare_hessian(const Vector& u, const Projected&) {
  // b (T - t t^T/|t|^2)/|t|, T the tangential projector: positive semi-definite, and zero in 2D.
  block_.clear();
  if constexpr (D == 2) return;
  for (const NodeConstraint<D>& c : set_.constrained) {
    if (!(c.rub_bound > 0)) continue;
    const Vec<D> t = slip_at(c, u);
    const double length = t.norm();
    if (at_rest(c, t, set_.rounding)) continue;
    const Mat<D> T = c.free * (Mat<D>::Identity() - c.rub_normal * c.rub_normal.transpose()) * c.free;
    block_.emplace_back(c.node, c.rub_bound / length * (T - t * t.transpose() / (length * length)));
  }
}

template <int D>
void Friction<D>::hessian_product(const Vector& p, Vector& Hp) {
  for (const auto& [node, B] : block_) Hp.segment<D>(node * D) += B * p.segment<D>(node * D);
}

template <int D>
void Friction<D>::diagonal(std::vector<Mat<D>>& blocks) {
  for (const auto& [node, B] : block_) blocks[static_cast<std::size_t>(node)] += B;
}

template <int D>
void Friction<D>::assemble(BlockMatrix<D>& H) {
  for (const auto& [node, B] : block_) H.at(node, node) += B;
}

template class Friction<2>;
template class Friction<3>;

}  // namespace pf
