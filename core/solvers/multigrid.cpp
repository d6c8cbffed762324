#include "core/solvers/multigrid.hpp"

#include <algorithm>

#include "core/math/vector_ops.hpp"

namespace pf {

namespace {

/// Levels of no more rows are solved directly.
constexpr int most_rows_of_coarsest = 100;

/// Q A Q for the rows and columns of nodes that are not free.
template <int D>
class Restriction {
 public:
  using Block = Eigen::Matrix<float, D, D>;

  /// `held` is referred to.
  Restriction(const LinearProblem<D>& problem, const std::vector<std::int32_t>& row_of, StencilMatrix<D>& A,
              HeldRows<D>& held)
      : A_(A), at_(held.at), Q_(held.Q) {
    at_.assign(static_cast<std::size_t>(A.layout->rows()), -1);
    Q_.clear();
    for (std::size_t i = 0; i < problem.directions.size(); ++i) {
      if (problem.directions[i].isIdentity(0)) continue;
      const auto node = static_cast<std::size_t>(problem.set.constrained[i].node);
      at_[static_cast<std::size_t>(row_of[node])] = static_cast<std::int32_t>(Q_.size());
      Q_.push_back(problem.directions[i].template cast<float>());
    }
  }
  bool empty() const { return Q_.empty(); }

  void apply(int row) {
    const std::int32_t own = at_[static_cast<std::size_t>(row)];
    if (own >= 0) {
      Eigen::Map<Block> diagonal(A_.diagonal_block(row));
      const Block& Q = Q_[static_cast<std::size_t>(own)];
      diagonal = (Q * diagonal * Q).eval();
    }
    const std::int32_t* const windows = A_.layout->windows(row);
    const int side = 2 * A_.layout->reach() + 1;
    for (int l = 0; l < A_.layout->lines(); ++l)
      for (int k = 0; windows[l] >= 0 && k < side; ++k) {
        const std::int32_t other = A_.layout->row_at(windows[l] + k);
        const std::int32_t their = other < 0 ? -1 : at_[static_cast<std::size_t>(other)];
        if (own < 0 && their < 0) continue;
        float* const entries = A_.row(row) + static_cast<std::ptrdiff_t>(l) * D * A_.width + k * D;
        Block B;
        for (int a = 0; a < D; ++a)
          for (int c = 0; c < D; ++c) B(a, c) = entries[a * A_.width + c];
        if (own >= 0) B = (Q_[static_cast<std::size_t>(own)] * B).eval();
        if (their >= 0) B = (B * Q_[static_cast<std::size_t>(their)]).eval();
        for (int a = 0; a < D; ++a)
          for (int c = 0; c < D; ++c) entries[a * A_.width + c] = B(a, c);
      }
  }

 private:
  StencilMatrix<D>& A_;
  std::vector<std::int32_t>& at_;
  std::vector<Block>& Q_;
};

}  // namespace

template <int D>
void Multigrid<D>::lay_out(const LinearProblem<D>& problem) {
  const Lattice<D> lattice = problem.objective.lattice();
  const auto level = [&](std::size_t k) -> MultigridLevel<D>& {
    if (levels_.size() <= k) levels_.push_back(std::make_unique<MultigridLevel<D>>());
    return *levels_[k];
  };
  level(0).layout.build(lattice.index, lattice.reach, row_of_);
  level(0).resize();
  count_ = 1;
  while (level(count_ - 1).layout.rows() > most_rows_of_coarsest) {
    level(count_ - 1).connect(level(count_));
    if (level(count_).layout.rows() >= level(count_ - 1).layout.rows()) break;  // scattered nodes: no coarser grid
    ++count_;
  }
  laid_out_ = true;
}

template <int D>
void Multigrid<D>::constrain(const LinearProblem<D>& problem) {
  MultigridLevel<D>& finest = *levels_.front();
  Restriction<D> restriction(problem, row_of_, finest.A, held_);
  if (restriction.empty()) return;
  for_pieces(parallel_, finest.layout.rows(), [&](std::ptrdiff_t begin, std::ptrdiff_t count) {
    for (std::ptrdiff_t i = begin; i < begin + count; ++i) restriction.apply(static_cast<int>(i));
  });
}

template <int D>
void Multigrid<D>::factorize() {
  const MultigridLevel<D>& level = *levels_[count_ - 1];
  const StencilLayout<D>& layout = level.layout;
  factorized_ = false;
  if (layout.rows() > 4 * most_rows_of_coarsest) return;
  const int side = 2 * layout.reach() + 1;
  Eigen::MatrixXd& dense = dense_;
  dense.setZero(layout.rows() * D, layout.rows() * D);
  for (int i = 0; i < layout.rows(); ++i) {
    for (int a = 0; a < D; ++a)
      for (int c = 0; c < D; ++c) dense(i * D + a, i * D + c) = level.A.diagonal_block(i)[a + D * c];
    for (int l = 0; l < layout.lines(); ++l)
      for (int k = 0; layout.windows(i)[l] >= 0 && k < side; ++k) {
        const int j = layout.row_at(layout.windows(i)[l] + k);
        if (j < 0 || j >= i) continue;
        const float* const entries = level.A.row(i) + static_cast<std::ptrdiff_t>(l) * D * level.A.width + k * D;
        for (int a = 0; a < D; ++a)
          for (int c = 0; c < D; ++c) dense(i * D + a, j * D + c) = entries[a * level.A.width + c];
      }
  }
  // What has no stiffness, and what rounding left of it, is held still.
  const double least = 1e-6 * dense.diagonal().maxCoeff();
  for (Eigen::Index k = 0; k < dense.rows(); ++k)
    if (!(dense(k, k) > least)) dense(k, k) += std::max(1e-300, dense.diagonal().maxCoeff());
  coarsest_.compute(dense);
  const auto n = static_cast<std::uint64_t>(dense.rows());
  this->work_.operations += n * n * n / 6;
  factorized_ = coarsest_.info() == Eigen::Success;
}

template <int D>
void Multigrid<D>::prepare(const LinearProblem<D>& problem) {
  if (!laid_out_) lay_out(problem);
  MultigridLevel<D>& finest = *levels_.front();
  finest.A.shape(finest.layout);
  problem.objective.assemble_stencil(finest.A, row_of_);
  constrain(problem);
  for (std::size_t k = 0; k + 1 < count_; ++k) {
    levels_[k]->invert_diagonal(parallel_);
    levels_[k]->coarsen(*levels_[k + 1], parallel_);
    this->work_.stencil_operations += levels_[k]->coarsening_operations();
  }
  levels_[count_ - 1]->invert_diagonal(parallel_);
  factorize();
  build_patches();
}

template <int D>
void Multigrid<D>::build_patches() {
  for (std::size_t k = 0; k < count_; ++k) {
    MultigridLevel<D>& level = *levels_[k];
    if (!strong_ || (factorized_ && k + 1 == count_)) {
      level.patches.clear();
    } else {
      level.patches.build(level.A, parallel_);
      this->work_.stencil_operations += level.patches.build_operations();
    }
  }
}

template <int D>
bool Multigrid<D>::strengthen() {
  if (strong_) return false;
  strong_ = true;
  build_patches();
  return true;
}

template <int D>
void Multigrid<D>::solve_coarsest() {
  MultigridLevel<D>& level = *levels_[count_ - 1];
  if (!factorized_) {
    level.smooth_from_zero(parallel_);
    level.smooth_back(parallel_);
    this->work_.stencil_operations += level.cycle_operations();
    return;
  }
  const StencilLayout<D>& layout = level.layout;
  solution_.resize(layout.rows() * D);
  const auto at = [&](int i) { return static_cast<std::size_t>(layout.slot(i)) * D; };
  for (int i = 0; i < layout.rows(); ++i)
    for (std::size_t a = 0; a < D; ++a) solution_[i * D + static_cast<int>(a)] = level.b[at(i) + a];
  coarsest_.solveInPlace(solution_);
  this->work_.operations += static_cast<std::uint64_t>(solution_.size() * solution_.size());
  for (int i = 0; i < layout.rows(); ++i)
    for (std::size_t a = 0; a < D; ++a) level.x[at(i) + a] = static_cast<float>(solution_[i * D + static_cast<int>(a)]);
}

template <int D>
void Multigrid<D>::cycle(std::size_t k) {
  if (k + 1 == count_) return solve_coarsest();
  MultigridLevel<D>& level = *levels_[k];
  level.smooth_from_zero(parallel_);
  level.restrict_to(*levels_[k + 1], parallel_);
  cycle(k + 1);
  level.prolong_from(*levels_[k + 1], parallel_);
  level.smooth_back(parallel_);
  this->work_.stencil_operations += level.cycle_operations();
}

template <int D>
void Multigrid<D>::apply(const LinearProblem<D>& problem, const Vector& r, Vector& z) {
  MultigridLevel<D>& finest = *levels_.front();
  const auto nodes = static_cast<std::ptrdiff_t>(row_of_.size());
  const auto at = [&](std::ptrdiff_t i) {
    return static_cast<std::ptrdiff_t>(finest.layout.slot(row_of_[static_cast<std::size_t>(i)])) * D;
  };
  for_pieces(parallel_, nodes, [&](std::ptrdiff_t begin, std::ptrdiff_t count) {
    for (std::ptrdiff_t i = begin; i < begin + count; ++i)
      for (int a = 0; a < D; ++a) finest.b[static_cast<std::size_t>(at(i) + a)] = static_cast<float>(r[i * D + a]);
  });
  cycle(0);
  z.resize(r.size());
  for_pieces(parallel_, nodes, [&](std::ptrdiff_t begin, std::ptrdiff_t count) {
    for (std::ptrdiff_t i = begin; i < begin + count; ++i)
      for (int a = 0; a < D; ++a) z[i * D + a] = finest.x[static_cast<std::size_t>(at(i) + a)];
  });
  problem.set.restrict_to(problem.directions, z);
}

template class Multigrid<2>;
template class Multigrid<3>;

}  // namespace pf
