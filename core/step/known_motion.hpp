// A scene whose motion is known: initial state, errors, and for a manufactured solution the loads that make it true
// (THEORY T7).
#pragma once

#include <optional>

#include "core/energies/elastic.hpp"
#include "core/grid/plan.hpp"
#include "core/scene/manufactured.hpp"
#include "core/step/conditions.hpp"
#include "core/step/surface.hpp"
#include "core/step_report.hpp"

namespace pf {

template <int D>
class KnownMotion {
 public:
  /// `conditions`: where they hold a surface, it gets no manufactured traction in the directions that are held.
  KnownMotion(const Scene& scene, const Conditions<D>& conditions);

  bool known() const { return motion_.has_value(); }
  bool manufactured() const { return manufactured_; }
  /// x, v and F of every particle at t = 0.
  void set_initial_state(Particles<D>& particles) const;
  /// Adds the manufactured body force and tractions at stage time t [N].
  void add_force(const Plan<D>& plan, const Particles<D>& particles, const Laws<D>& laws, const Scene& scene, double t,
                 Parallel& parallel, Vector& f) const;
  /// Mass-weighted norms of what the particles are off (INTERFACE, stats.csv).
  ErrorNorms errors(const Particles<D>& particles, double t, Parallel& parallel) const;
  /// |x_p - exact| of each particle [m].
  void displacement_errors(const Particles<D>& particles, double t, std::vector<double>& error) const;
  SurfacePoints<D>& surface() { return surface_; }
  const SurfacePoints<D>& surface() const { return surface_; }

 private:
  std::optional<ExactMotion<D>> motion_;
  bool manufactured_ = false;
  SurfacePoints<D> surface_;  ///< tag: the body's material
  std::vector<Mat<D>> free_;  ///< directions of each point that nothing holds
};

extern template class KnownMotion<2>;
extern template class KnownMotion<3>;

}  // namespace pf
