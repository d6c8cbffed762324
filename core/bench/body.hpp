// A block of material as kernels see it: particles, their plan, a grid state, an elastic energy at a deformed state.
#pragma once

#include "core/energies/elastic.hpp"
#include "core/integrators/potential.hpp"
#include "core/transfers/transfer.hpp"

namespace pf::bench {

template <int D>
struct Body {
  Body(std::string_view basis, std::size_t about_particles, int threads);
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  /// Particles move to and fro by up to half a cell: some leave theirs.
  void shake();
  void build_plan();
  /// Displacements of the nodes: a smooth field of gradients up to 0.05.
  Vector displacements() const;

  static constexpr double spacing = 1.0 / 64;
  Parallel parallel;
  const BasisInfo& basis;
  Particles<D> particles;
  Plan<D> plan;
  Laws<D> laws;
  GridState<D> grid;
  Work work;
  FeasibleSet<D> set;  ///< nothing is held
  int shaken = 0;
};

extern template struct Body<2>;
extern template struct Body<3>;

}  // namespace pf::bench
