// Dead loads of a step: - f_ext . u (THEORY T3): gravity, body forces and tractions, all evaluated at the stage time.
#pragma once

#include "core/energies/energy.hpp"

namespace pf {

template <int D>
class ExternalWork final : public Energy<D> {
 public:
  /// `force`: f_ext, D components a node [N]; referred to.
  explicit ExternalWork(const Vector& force) : force_(force) {}
  double value(const Vector& u) override { return -force_.dot(u); }
  double gradient(const Vector& u, Vector& g, Vector&) override {
    g -= force_;
    return value(u);
  }
  void prepare_hessian(const Vector&, const Projected&) override {}
  void hessian_product(const Vector&, Vector&) override {}
  void diagonal(std::vector<Mat<D>>&) override {}
  void assemble(BlockMatrix<D>&) override {}

 private:
  const Vector& force_;
};

}  // namespace pf
