// Shape functions as curves of one direction: N(s - i) of the nodes whose function is not zero at s (THEORY T2).
#pragma once

#include <functional>

#include "app/context.hpp"
#include "core/bases/basis.hpp"
#include "core/charts/painter.hpp"

namespace pf::app {

/// N_i(s) of the node i, s = x/dx. Of an averaged basis its mean over `width` cells about s, at most one.
double shape_value(const BasisInfo& basis, double s, long long node, double width = 0);

struct ShapeCurves {
  const BasisInfo* basis = nullptr;
  double s = 0;                                 ///< where they are cut
  double width = 0;                             ///< of the particle's domain, of an averaged basis [cells]
  std::function<Point2(double, double)> place;  ///< of (s, N)
  float em = 15;
  Theme theme = Theme::dark;
  bool values = true;  ///< writes N at the cut
};
/// The curves, their axis, the nodes on it, and the cut with its values.
void draw_shape_curves(Painter& painter, const ShapeCurves& curves);

/// A box in a panel with the curves of each axis at x [m]; `domain`: the particle's widths there [cells], which an
/// averaged basis is averaged over.
void shape_plot(const AppContext& context, const Vec3& x, const Vec3& domain);

}  // namespace pf::app
