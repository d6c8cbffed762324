#include "core/integrators/potential.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace pf {

template <int D>
IncrementalPotential<D>::IncrementalPotential(const Plan<D>& plan, const Vector& lumped_mass, const FeasibleSet<D>& set,
                                              const std::vector<Energy<D>*>& terms,
                                              std::span<const Vector* const> reference_forces,
                                              PotentialVectors<D>* vectors)
    : plan_(plan), set_(set), term_count_(terms.size()), vectors_(vectors ? *vectors : own_) {
  assert(terms.size() <= terms_.size());
  std::copy(terms.begin(), terms.end(), terms_.begin());
  const Eigen::Index n = lumped_mass.size();
  // A node that holds next to nothing must not decide alone whether the step has converged.
  const double least = 1e-9 * lumped_mass.maxCoeff();
  vectors_.weight.resize(n * D);
  for (Eigen::Index i = 0; i < n; ++i)
    vectors_.weight.template segment<D>(i * D).setConstant(1 / std::max(lumped_mass[i], least));
  vectors_.fixed.assign(static_cast<std::size_t>(n), 0);
  vectors_.free.clear();
  for (const NodeConstraint<D>& c : set.constrained) {
    vectors_.free.push_back(c.free);
    if (c.free.isZero()) vectors_.fixed[static_cast<std::size_t>(c.node)] = 1;
  }
  for (const Vector* f : reference_forces) {
    vectors_.over_free = *f;
    set.restrict_to(vectors_.free, vectors_.over_free);
    reference_ = std::max(reference_, norm(vectors_.over_free));
  }
}

template <int D>
double IncrementalPotential<D>::value(const Vector& u) {
  double E = 0;
  energy_scale_ = 0;
  for (Energy<D>* term : terms()) {
    const double part = term->value(u);
    E += part;
    energy_scale_ += std::abs(part);
  }
  return E;
}

template <int D>
double IncrementalPotential<D>::gradient(const Vector& u, Vector& g) {
  g.setZero(u.size());
  vectors_.magnitude.setZero(u.size() / D);
  double E = 0;
  energy_scale_ = 0;
  for (Energy<D>* term : terms()) {
    const double part = term->gradient(u, g, vectors_.magnitude);
    E += part;
    energy_scale_ += std::abs(part);
  }
  return E;
}

template <int D>
void IncrementalPotential<D>::prepare_hessian(const Vector& u, const Projected& project) {
  for (Energy<D>* term : terms()) term->prepare_hessian(u, project);
}

template <int D>
void IncrementalPotential<D>::hessian_product(const Vector& p, Vector& Hp) {
  for (Energy<D>* term : terms()) term->hessian_product(p, Hp);
}

template <int D>
void IncrementalPotential<D>::diagonal(std::vector<Mat<D>>& blocks) {
  for (Energy<D>* term : terms()) term->diagonal(blocks);
}

template <int D>
void IncrementalPotential<D>::make_pattern(BlockMatrix<D>& H) const {
  const int K = plan_.nodes_per_axis(), edge = block_edge + K - 1;
  const int count = D == 2 ? K * K : K * K * K;
  std::vector<std::vector<std::int32_t>> columns(static_cast<std::size_t>(plan_.node_count()));
  for (const Block<D>& block : plan_.blocks()) {
    const std::int32_t* table = plan_.node_table(block);
    int previous = -1;
    for (int i = block.batch_begin; i < block.batch_end; ++i) {
      const int first = plan_.batches()[static_cast<std::size_t>(i)].node;
      if (first == previous) continue;
      previous = first;
      for (int r = 0; r < count; ++r)
        for (int c = 0; c < count; ++c) {
          const std::int32_t row = table[first + r % K + edge * (r / K % K + edge * (r / (K * K)))];
          const std::int32_t column = table[first + c % K + edge * (c / K % K + edge * (c / (K * K)))];
          if (column >= 0 && row >= column) columns[static_cast<std::size_t>(row)].push_back(column);
        }
    }
  }
  for (const Energy<D>* term : terms())
    term->far_pairs([&](std::int32_t i, std::int32_t j) { columns[static_cast<std::size_t>(i)].push_back(j); });
  H.row_start.assign(1, 0);
  H.column.clear();
  for (std::vector<std::int32_t>& row : columns) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    H.column.insert(H.column.end(), row.begin(), row.end());
    H.row_start.push_back(static_cast<std::int64_t>(H.column.size()));
  }
  H.block.resize(H.column.size());
}

template <int D>
void IncrementalPotential<D>::assemble(BlockMatrix<D>& H) {
  if (!have_pattern_) make_pattern(H);
  have_pattern_ = true;
  H.set_zero();
  for (Energy<D>* term : terms()) term->assemble(H);
}

template <int D>
void IncrementalPotential<D>::assemble_stencil(StencilMatrix<D>& H, const std::vector<std::int32_t>& row_of) {
  std::vector<Mat<D>> blocks(row_of.size(), Mat<D>::Zero());
  for (Energy<D>* term : terms())
    if (!term->assemble_stencil(H, row_of)) term->diagonal(blocks);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    float* const to = H.diagonal_block(row_of[i]);
    for (int k = 0; k < D * D; ++k) to[k] += static_cast<float>(blocks[i](k));
  }
}

template <int D>
double IncrementalPotential<D>::norm(const Vector& g) const {
  return std::sqrt(g.cwiseAbs2().dot(vectors_.weight));
}

/// Of free nodes, an entry each.
template <int D>
double IncrementalPotential<D>::norm_of_sizes(const Vector& sizes) const {
  double s = 0;
  for (Eigen::Index i = 0; i < sizes.size(); ++i)
    if (!vectors_.fixed[static_cast<std::size_t>(i)]) s += sizes[i] * sizes[i] * vectors_.weight[i * D];
  return std::sqrt(s);
}

template <int D>
double IncrementalPotential<D>::scale() const {
  return std::max(reference_, norm_of_sizes(vectors_.magnitude));
}

template <int D>
double IncrementalPotential<D>::rounding() {
  if (rounding_ >= 0) return rounding_;
  vectors_.rounding.setZero(static_cast<Eigen::Index>(plan_.node_count()));
  for (Energy<D>* term : terms()) stiffness_ += term->rounding(vectors_.rounding);
  return rounding_ = norm_of_sizes(vectors_.rounding);
}

template class IncrementalPotential<2>;
template class IncrementalPotential<3>;

}  // namespace pf
