// External forces of a step (THEORY T3): gravity, body forces, tractions on the bodies' reference surfaces.
#pragma once

#include "core/grid/particles.hpp"
#include "core/grid/plan.hpp"
#include "core/scene/scene.hpp"
#include "core/step/formulas.hpp"
#include "core/step/surface.hpp"

namespace pf {

template <int D>
class Loads {
 public:
  explicit Loads(const Scene& scene);

  void set_gravity(const Vec3& gravity) { gravity_ = gravity.head<D>(); }
  const Vec<D>& gravity() const { return gravity_; }
  /// Body force and tractions of a scene whose loads act on the same surfaces.
  void set_formulas(const Scene& scene);
  /// The loaded surfaces; `tag` is the load's index.
  SurfacePoints<D>& surface() { return surface_; }
  const SurfacePoints<D>& surface() const { return surface_; }

  /// `f` becomes f_ext of all nodes at stage time t [N].
  void force(const Plan<D>& plan, const Particles<D>& particles, const Vector& lumped_mass, double t,
             Parallel& parallel, Vector& f) const;

 private:
  Vec<D> gravity_;
  FormulaField<D> body_force_;
  std::vector<FormulaField<D>> traction_;
  SurfacePoints<D> surface_;
};

extern template class Loads<2>;
extern template class Loads<3>;

}  // namespace pf
