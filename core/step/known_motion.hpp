// A scene whose motion is known: initial state, errors, and for a manufactured solution the loads that make it true
// (THEORY T7).
#pragma once

#include "core/grid/particles.hpp"
#include "core/materials/law.hpp"
#include "core/scene/scene.hpp"
#include "core/step_report.hpp"

namespace pf {

template <int D>
class KnownMotion {
 public:
  explicit KnownMotion(const Scene&) {}
  bool known() const { return false; }
  bool manufactured() const { return false; }
  void set_initial_state(Particles<D>&) const {}
  void set_laws(const std::vector<std::unique_ptr<Law<D>>>&) {}
  void add_force(const Plan<D>&, const Particles<D>&, double, Parallel&, Vector&) const {}
  ErrorNorms errors(const Particles<D>&, double) const { return {}; }
  void displacement_errors(const Particles<D>&, double, std::vector<double>&) const {}
};

}  // namespace pf
