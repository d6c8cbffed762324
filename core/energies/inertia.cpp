#include "core/energies/inertia.hpp"

namespace pf {

template <int D>
double Inertia<D>::value(const Vector& u) {
  difference_ = u - u_free_;
  mass_.multiply(difference_, product_);
  return 0.5 * scale_ * mass_.dot(difference_, product_);
}

template <int D>
double Inertia<D>::gradient(const Vector& u, Vector& g, Vector&) {
  const double E = value(u);
  g += scale_ * product_;
  return E;
}

template <int D>
void Inertia<D>::hessian_product(const Vector& p, Vector& Hp) {
  mass_.multiply(p, product_);
  Hp += scale_ * product_;
}

template <int D>
void Inertia<D>::diagonal(std::vector<Mat<D>>& blocks) {
  const Vector& m = mass_.diagonal();
  for (std::size_t i = 0; i < blocks.size(); ++i)
    blocks[i].diagonal().array() += scale_ * m[static_cast<Eigen::Index>(i)];
}

template <int D>
void Inertia<D>::assemble(BlockMatrix<D>& H) {
  mass_.assemble(scale_, H);
}

template <int D>
Vector Inertia<D>::free_flight_force() const {
  Vector f;
  mass_.multiply(u_free_, f);
  return scale_ * f;
}

template class Inertia<2>;
template class Inertia<3>;

}  // namespace pf
