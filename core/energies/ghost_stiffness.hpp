// What holds nodes at free edges in a step without inertia: gamma k / 2 |D u|^2 over the grid's lines through light
// nodes (core/grid/ghost_penalty.hpp), k a node's stiffness [N/m]. Third differences are of order dx^3, so the order of
// convergence stays (Coombs 2023, IJNME 124: ghost stabilisation of implicit quasi-static MPM).
#pragma once

#include "core/energies/energy.hpp"
#include "core/grid/ghost_penalty.hpp"

namespace pf {

template <int D>
class GhostStiffness final : public Energy<D> {
 public:
  /// `ghost`: built of stiffnesses instead of masses; referred to.
  explicit GhostStiffness(const GhostPenalty<D>& ghost) : ghost_(ghost) {}
  double value(const Vector& u) override {
    force_.setZero(u.size());
    ghost_.add_product(u, force_);
    return 0.5 * u.dot(force_);
  }
  double gradient(const Vector& u, Vector& g, Vector&) override {
    const double E = value(u);
    g += force_;
    return E;
  }
  void prepare_hessian(const Vector&, const Projected&) override {}
  void hessian_product(const Vector& p, Vector& Hp) override { ghost_.add_product(p, Hp); }
  void diagonal(std::vector<Mat<D>>& blocks) override {
    Vector diagonal = Vector::Zero(static_cast<Eigen::Index>(blocks.size()));
    ghost_.add_diagonal(diagonal);
    for (std::size_t i = 0; i < blocks.size(); ++i)
      blocks[i].diagonal().array() += diagonal[static_cast<Eigen::Index>(i)];
  }
  void far_pairs(const std::function<void(std::int32_t, std::int32_t)>& add) const override { ghost_.pairs(add); }
  void assemble(BlockMatrix<D>& H) override { ghost_.assemble(1, H); }

 private:
  const GhostPenalty<D>& ghost_;
  Vector force_;
};

}  // namespace pf
