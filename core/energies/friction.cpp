#include "core/energies/friction.hpp"

#include <cmath>

namespace pf {

template <int D>
Vec<D> Friction<D>::slip_of(const FrictionContact<D>& c, const Vector& u) const {
  const Vec<D> w = u.segment<D>(c.node * D) - c.wall;
  return w - c.normal * c.normal.dot(w);
}

template <int D>
double Friction<D>::value(const Vector& u) {
  double E = 0;
  for (const FrictionContact<D>& c : contacts_) {
    const double s2 = slip_of(c, u).squaredNorm(), length = std::sqrt(s2 + slip_ * slip_);
    E += c.coefficient * c.normal_force * s2 / (length + slip_);
  }
  return E;
}

template <int D>
double Friction<D>::gradient(const Vector& u, Vector& g, Vector& magnitude) {
  for (const FrictionContact<D>& c : contacts_) {
    const Vec<D> t = slip_of(c, u);
    const double f = c.coefficient * c.normal_force;
    g.segment<D>(c.node * D) += f / std::sqrt(t.squaredNorm() + slip_ * slip_) * t;
    magnitude[c.node] += f;
  }
  return value(u);
}

template <int D>
void Friction<D>::prepare_hessian(const Vector& u, bool) {
  // mu f_n (T - t t^T/l^2)/l, l^2 = |t|^2 + eps^2, T the tangential projector: positive semi-definite as it is.
  block_.clear();
  for (const FrictionContact<D>& c : contacts_) {
    const Vec<D> t = slip_of(c, u);
    const double l2 = t.squaredNorm() + slip_ * slip_;
    block_.push_back(c.coefficient * c.normal_force / std::sqrt(l2) *
                     (Mat<D>::Identity() - c.normal * c.normal.transpose() - t * t.transpose() / l2));
  }
}

template <int D>
void Friction<D>::hessian_product(const Vector& p, Vector& Hp) {
  for (std::size_t i = 0; i < contacts_.size(); ++i)
    Hp.segment<D>(contacts_[i].node * D) += block_[i] * p.segment<D>(contacts_[i].node * D);
}

template <int D>
void Friction<D>::diagonal(std::vector<Mat<D>>& blocks) {
  for (std::size_t i = 0; i < contacts_.size(); ++i) blocks[static_cast<std::size_t>(contacts_[i].node)] += block_[i];
}

template <int D>
void Friction<D>::assemble(BlockMatrix<D>& H) {
  for (std::size_t i = 0; i < contacts_.size(); ++i) H.at(contacts_[i].node, contacts_[i].node) += block_[i];
}

template class Friction<2>;
template class Friction<3>;

}  // namespace pf
