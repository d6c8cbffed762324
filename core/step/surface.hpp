// Points of a body's reference surface that carry tractions (THEORY T3).
#pragma once

#include "core/grid/plan.hpp"
#include "core/scene/scene.hpp"
#include "core/scene/solid.hpp"

namespace pf {

/// Reference position and area are fixed; the current position is carried along by the grid, like a particle's.
template <int D>
struct SurfacePoints {
  std::vector<Vec<D>> X, x;        ///< reference and current position [m]
  std::vector<Vec<D>> normal;      ///< outward reference normal
  std::vector<double> area;        ///< reference area A_s [m^(D-1)], unit thickness in 2D
  std::vector<std::uint16_t> tag;  ///< whose point it is

  std::size_t size() const { return X.size(); }
  /// Adds the points of the body's surface that `accept` takes.
  template <class Accept>
  void add(const Scene& scene, const Body& body, std::uint16_t whose, Accept&& accept) {
    const double h = scene.grid.spacing / (D == 2 ? 8 : 4);
    for (const SurfacePoint& point : make_solid(body.shape, D, scene.constants)->surface(h)) {
      if (!accept(point)) continue;
      X.push_back(point.position.template head<D>());
      x.push_back(X.back());
      normal.push_back(point.normal.template head<D>());
      area.push_back(point.area);
      tag.push_back(whose);
    }
  }
  /// f_i += sum_s N_i(x_s) traction_s A_s. Where a point lies beside empty cells its shape functions are restricted to
  /// the active nodes and renormalised: the force is kept, its moment about the point becomes that of the nodes'
  /// centre.
  void spread(const Plan<D>& plan, const std::vector<Vec<D>>& traction, Vector& f) const;
  /// x_s += sum_i u_i N_i(x_s).
  void move(const Plan<D>& plan, const Vector& u);
};

extern template struct SurfacePoints<2>;
extern template struct SurfacePoints<3>;

}  // namespace pf
