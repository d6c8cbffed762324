// Shape functions as curves of one direction: N(s - i) of the nodes whose function is not zero at s (THEORY T2).
#pragma once

#include <functional>
#include <vector>

#include "app/context.hpp"
#include "core/bases/basis.hpp"
#include "core/charts/painter.hpp"
#include "core/grid/domain.hpp"

namespace pf::app {

/// N_i(s) of the node i, s = x/dx. Of an averaged basis its mean over the domain whose pieces are given (none: N_i).
double shape_value(const BasisInfo& basis, double s, long long node, const std::vector<DomainPiece>& domain = {});
/// Of a particle of a scene with an averaged basis: its domain as the step sees it, along an axis; else none. `rest`:
/// Snapshot::domain_of the particle.
std::vector<DomainPiece> domain_along(const Scene& scene, const ParticleState& particle, int axis,
                                      const float* rest = nullptr);

struct ShapeCurves {
  const BasisInfo* basis = nullptr;
  double s = 0;                                 ///< where they are cut
  std::vector<DomainPiece> domain;              ///< of the particle, of an averaged basis
  std::function<Point2(double, double)> place;  ///< of (s, N)
  float em = 15;
  Theme theme = Theme::dark;
  bool values = true;  ///< writes N at the cut, in a column at the end of the axis
  float aside = 0;     ///< how far beyond it
};
/// The curves, their axis, the nodes on it, and the cut with its values.
void draw_shape_curves(Painter& painter, const ShapeCurves& curves);

/// A box in a panel with the curves of each axis where the particle is.
void shape_plot(const AppContext& context, const ParticleState& particle);

}  // namespace pf::app
