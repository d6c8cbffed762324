#include "core/energies/inertia.hpp"

namespace pf {

template <int D>
double Inertia<D>::value(const Vector& u) {
  vectors_.difference = u - vectors_.u_free;
  mass_.multiply(vectors_.difference, vectors_.product);
  return 0.5 * scale_ * mass_.dot(vectors_.difference, vectors_.product);
}

template <int D>
double Inertia<D>::gradient(const Vector& u, Vector& g, Vector&) {
  const double E = value(u);
  g += scale_ * vectors_.product;
  return E;
}

template <int D>
void Inertia<D>::hessian_product(const Vector& p, Vector& Hp) {
  mass_.multiply(p, vectors_.product);
  Hp += scale_ * vectors_.product;
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
void Inertia<D>::free_flight_force(Vector& f) const {
  mass_.multiply(vectors_.u_free, f);
  f *= scale_;
}

template class Inertia<2>;
template class Inertia<3>;

}  // namespace pf
