// Loads that make a typed motion the solution (THEORY T7, manufactured solutions), for any hyperelastic law.
#pragma once

#include <span>

#include "core/materials/law.hpp"
#include "core/scene/exact_motion.hpp"

namespace pf {

/// Evaluation allocates nothing and is thread-safe. `motion` and `law` must outlive it.
template <int D>
class ManufacturedLoads {
 public:
  /// `density` R0 [kg/m^3]; `gravity` [m/s^2] acts beside what is derived here.
  ManufacturedLoads(const ExactMotion<D>& motion, const Law<D>& law, double density, const Vec<D>& gravity)
      : motion_(motion), law_(law), density_(density), gravity_(gravity) {}

  /// b = phi_tt - Div P/R0 - gravity [m/s^2] at each reference point, with Div P_a = dP_aA/dF_bB d2phi_b/dX_A dX_B.
  void body_acceleration(std::span<const Vec<D>> X, double t, std::span<Vec<D>> b) const;
  /// P(X, t) N [Pa], nominal, at reference points with outward unit normal N.
  void traction(std::span<const Vec<D>> X, std::span<const Vec<D>> N, double t, std::span<Vec<D>> traction) const;

 private:
  const ExactMotion<D>& motion_;
  const Law<D>& law_;
  double density_;
  Vec<D> gravity_;
};

extern template class ManufacturedLoads<2>;
extern template class ManufacturedLoads<3>;

}  // namespace pf
