// The particles: all that survives from one step to the next.
#pragma once

#include <cstdint>
#include <vector>

#include "core/types.hpp"

namespace pf {

/// One entry a particle in each array, in the order of the newest plan (core/grid/plan.hpp).
template <int D>
struct Particles {
  std::vector<Vec<D>> X;                ///< reference position [m]
  std::vector<Vec<D>> x;                ///< position [m]
  std::vector<Vec<D>> v;                ///< velocity [m/s]
  std::vector<Mat<D>> F;                ///< deformation gradient
  std::vector<Mat<D>> C;                ///< APIC's affine velocity B D^-1 [1/s]; zero under other transfers
  std::vector<double> mass;             ///< m_p = R0 V_p^0 [kg]
  std::vector<double> volume0;          ///< V_p^0 [m^D]
  std::vector<std::uint32_t> id;        ///< index at t = 0
  std::vector<std::uint16_t> body;      ///< into Scene::bodies
  std::vector<std::uint16_t> material;  ///< into Scene::materials

  std::size_t size() const { return x.size(); }
  /// Calls f(array) for each array: what sorting, saving and sizing have in common.
  template <class Function>
  void each(Function&& f) {
    f(X), f(x), f(v), f(F), f(C), f(mass), f(volume0), f(id), f(body), f(material);
  }
  template <class Function>
  void each(Function&& f) const {
    f(X), f(x), f(v), f(F), f(C), f(mass), f(volume0), f(id), f(body), f(material);
  }
};

}  // namespace pf
