// The particles: all that survives from one step to the next.
#pragma once

#include <cstdint>
#include <vector>

#include "core/math/scratch.hpp"
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
  std::vector<Vec<D>> a;                ///< acceleration [m/s^2]; empty unless the time scheme carries one
  std::vector<double> mass;             ///< m_p = R0 V_p^0 [kg]
  std::vector<double> volume0;          ///< V_p^0 [m^D]
  std::vector<std::uint32_t> id;        ///< in the order in which they came; never used again
  std::vector<std::uint16_t> body;      ///< into Scene::bodies
  std::vector<std::uint16_t> material;  ///< into Scene::materials

  std::size_t size() const { return x.size(); }
  /// Calls f(array) for each array: what sorting, saving and sizing have in common.
  template <class Function>
  void each(Function&& f) {
    f(X), f(x), f(v), f(F), f(C), f(a), f(mass), f(volume0), f(id), f(body), f(material);
  }
  template <class Function>
  void each(Function&& f) const {
    f(X), f(x), f(v), f(F), f(C), f(a), f(mass), f(volume0), f(id), f(body), f(material);
  }
};

/// Where a step puts what it changes of the particles: themselves, or memory that is read once, by the next plan. Until
/// then nothing of the particles has changed, and a step that comes to nothing is forgotten.
template <int D>
struct Motion {
  Vec<D>*x, *v;
  Mat<D>* F;  ///< null: stays what it is
  Mat<D>* C;  ///< null: stays what it is
  /// Room for a Vec<D> a particle, for sorting; null: it is allocated.
  Vec<D>* spare = nullptr;
  /// Where v, F and C of each particle go: its place in the next plan's order (Plan::foresee); null: the present one.
  /// Positions stand in the present order.
  const std::uint32_t* place = nullptr;
  /// Whose memory this is, if the particles may have it in exchange for theirs; null: it is copied.
  Particles<D>* owner = nullptr;
};

template <int D>
Motion<D> in_place(Particles<D>& particles) {
  return {particles.x.data(), particles.v.data(), particles.F.data(), particles.C.data()};
}
/// The particles' other memory: as much as theirs, exchanged for it by the next plan.
template <int D>
Motion<D> exchanged(const Particles<D>& particles, bool affine, Particles<D>& other) {
  other.X.resize(particles.size());
  other.x.resize(particles.size());
  other.v.resize(particles.size());
  other.F.resize(particles.size());
  other.C.resize(affine ? particles.size() : 0);
  Motion<D> motion = in_place(other);
  if (!affine) motion.C = nullptr;
  motion.spare = other.X.data();
  motion.owner = &other;
  return motion;
}
/// In `scratch`; `affine`: C changes too.
template <int D>
Motion<D> apart(std::size_t particles, bool affine, Scratch& scratch) {
  const std::size_t n = (particles + 7) / 8 * 8;  // each array begins aligned
  auto* const numbers = scratch.take<double>(n * (3 * D + (affine ? 2 : 1) * D * D));
  Motion<D> motion;
  motion.x = reinterpret_cast<Vec<D>*>(numbers);
  motion.v = reinterpret_cast<Vec<D>*>(numbers + n * D);
  motion.spare = reinterpret_cast<Vec<D>*>(numbers + n * 2 * D);
  motion.F = reinterpret_cast<Mat<D>*>(numbers + n * 3 * D);
  motion.C = affine ? reinterpret_cast<Mat<D>*>(numbers + n * (3 * D + D * D)) : nullptr;
  return motion;
}

}  // namespace pf
