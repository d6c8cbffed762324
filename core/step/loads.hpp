// External forces of a step (THEORY T3): gravity, body forces, tractions on the bodies' reference surfaces.
#pragma once

#include "core/grid/particles.hpp"
#include "core/grid/plan.hpp"
#include "core/scene/scene.hpp"
#include "core/step/formulas.hpp"

namespace pf {

/// Points of a loaded surface; they are carried along by the grid like particles.
template <int D>
struct SurfacePoints {
  std::vector<Vec<D>> X, x;     ///< reference and current position [m]
  std::vector<Vec<D>> normal;   ///< outward reference normal
  std::vector<double> area;     ///< reference area A_s [m^(D-1)]
  std::vector<std::uint16_t> load;
};

template <int D>
class Loads {
 public:
  explicit Loads(const Scene& scene);

  void set_gravity(const Vec3& gravity) { gravity_ = gravity.head<D>(); }
  const Vec<D>& gravity() const { return gravity_; }
  /// Body force and tractions with other formulas but the same surfaces.
  SurfacePoints<D>& surface() { return surface_; }
  const SurfacePoints<D>& surface() const { return surface_; }

  /// f_ext of all nodes at stage time t [N]. Where a surface point lies beside empty cells its shape functions are restricted to
  /// the active nodes and renormalised: the force is kept, its moment about the point is that of the nodes' centre.
  Vector force(const Plan<D>& plan, const Particles<D>& particles, const Vector& lumped_mass, double t,
               Parallel& parallel) const;
  /// The surface follows the grid: x_s += sum_i u_i N_i(x_s).
  void move(const Plan<D>& plan, const Vector& u);

 private:
  /// Calls f(node, weight) for the active nodes around x, weights adding up to 1; nothing when there are none.
  template <class Function>
  static void around(const Plan<D>& plan, const Vec<D>& x, Function&& f);

  Vec<D> gravity_;
  FormulaField<D> body_force_;
  std::vector<FormulaField<D>> traction_;
  SurfacePoints<D> surface_;
};

extern template class Loads<2>;
extern template class Loads<3>;

}  // namespace pf
