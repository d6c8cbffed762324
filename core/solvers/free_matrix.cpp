#include "core/solvers/free_matrix.hpp"

namespace pf {

template <int D>
void free_matrix(const LinearProblem<D>& problem, BlockMatrix<D>& H, Eigen::SparseMatrix<double>& lower) {
  problem.objective.assemble(H);
  const int rows = H.rows();
  // Constrained nodes keep their free directions only: Q_i Hij Q_j, and the identity elsewhere.
  std::vector<const Mat<D>*> Q(static_cast<std::size_t>(rows), nullptr);
  for (std::size_t i = 0; i < problem.directions.size(); ++i)
    Q[static_cast<std::size_t>(problem.set.constrained[i].node)] = &problem.directions[i];
  double size = 0;
  for (int i = 0; i < rows; ++i) size = std::max(size, H.at(i, i).trace());
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(H.block.size() * D * D);
  for (int row = 0; row < rows; ++row)
    for (auto k = H.row_start[static_cast<std::size_t>(row)]; k < H.row_start[static_cast<std::size_t>(row) + 1]; ++k) {
      const int column = H.column[static_cast<std::size_t>(k)];
      Mat<D> B = H.block[static_cast<std::size_t>(k)];
      if (const Mat<D>* q = Q[static_cast<std::size_t>(row)]) B = (*q * B).eval();
      if (const Mat<D>* q = Q[static_cast<std::size_t>(column)]) B = (B * *q).eval();
      if (row == column) {
        // What no particle weighs or stiffens is held still.
        if (const Mat<D>* q = Q[static_cast<std::size_t>(row)]) B += (Mat<D>::Identity() - *q) * size;
        for (int a = 0; a < D; ++a)
          if (!(B(a, a) > 1e-14 * size)) B(a, a) += 1e-14 * size;
      }
      for (int c = 0; c < D; ++c)
        for (int a = row == column ? c : 0; a < D; ++a) entries.emplace_back(row * D + a, column * D + c, B(a, c));
    }
  lower.resize(rows * D, rows * D);
  lower.setFromTriplets(entries.begin(), entries.end());
}

template void free_matrix<2>(const LinearProblem<2>&, BlockMatrix<2>&, Eigen::SparseMatrix<double>&);
template void free_matrix<3>(const LinearProblem<3>&, BlockMatrix<3>&, Eigen::SparseMatrix<double>&);

}  // namespace pf
