// An immutable picture of the state, for everybody who does not own the simulation: plain arrays, no types of
// the core's numerics. Buffers are pooled; only the requested fields are filled.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/diagnostics/fields.hpp"
#include "core/step_report.hpp"

namespace pf {

/// What a snapshot shall hold besides positions, F, volumes and ids.
struct SnapshotRequest {
  std::uint64_t fields = field_bit(Field::speed);  ///< field_bit of each; those of nodes need `grid`
  bool grid = false;                               ///< nodes
  bool velocities = false;                         ///< particle velocities
  bool reference = false;                          ///< reference positions
  bool stable_step = false;                        ///< how long an explicit step could be
  bool stress = false;                             ///< of particles, whole tensors
};

/// One probe at the newest state (INTERFACE, probes.csv).
struct ProbeReading {
  std::size_t probe = 0;
  std::uint32_t particle = 0;  ///< id
  Vec3 x = Vec3::Zero(), v = Vec3::Zero();
  Mat3 sigma = Mat3::Zero();  ///< Cauchy [Pa]
  Vec3 X = Vec3::Zero();      ///< reference position [m]
  Mat3 F = Mat3::Identity();
};

/// A rigid solid of the scene as it is drawn. `distance` is the signed distance at t = 0, negative in the solid;
/// thread-safe. At time t evaluate distance(p - displacement).
struct BoundaryView {
  std::function<double(const Vec3&)> distance;
  Vec3 min, max;  ///< bounds of its surface, infinite where unbounded
  std::string contact;
};
/// A region of constrained nodes or of loaded surface.
struct RegionView {
  std::function<double(const Vec3&)> distance;
  Vec3 min, max;
  std::string kind;  ///< "constraint" or "load"
};
/// What does not change during a run.
struct SceneView {
  std::vector<BoundaryView> boundaries;
  std::vector<RegionView> regions;
  std::vector<std::string> material_names;
  std::vector<std::string> body_names;
};

struct Snapshot {
  int dimension = 2;
  double spacing = 0;  ///< dx [m]
  StepReport report;   ///< of the newest accepted step: step, time, dt, balance, Newton's residuals, ...

  // Particles, in the simulation's own order; arrays of `dimension` components are interleaved.
  std::size_t particles = 0;
  std::vector<std::uint32_t> id;        ///< stable; with gaps where particles were cut away
  std::vector<std::uint16_t> body;      ///< into SceneView::body_names
  std::vector<std::uint16_t> material;  ///< into SceneView::material_names
  std::vector<double> x;                ///< [m]
  std::vector<float> F;                 ///< dimension^2 each, column-major
  std::vector<float> volume0;           ///< V_p^0 [m^dimension]
  /// Edges of the parallelepipeds that particles stood for at first [m], dimension^2 each, column-major, by id; null,
  /// not so far, or zero: cubes. Of bodies that are sampled `fitted`.
  std::shared_ptr<const std::vector<float>> domain;
  std::vector<float> v;                               ///< [m/s], if requested
  std::vector<double> X;                              ///< reference positions [m], if requested
  std::vector<float> stress;                          ///< Cauchy, xx yy zz xy yz xz each [Pa], if requested
  std::array<std::vector<float>, field_count> field;  ///< by Field, empty unless requested; of particles or of nodes

  // Active grid nodes of the last step, if requested: where they were at t^n and what the step did to them.
  std::size_t nodes = 0;
  std::vector<std::int32_t> node_index;   ///< lattice coordinates; x_i = dx * index
  std::vector<double> node_mass;          ///< m_i [kg]
  std::vector<double> node_velocity;      ///< v_i^{n+1} [m/s]
  std::vector<double> node_displacement;  ///< x^_i - x_i [m]
  std::vector<std::uint8_t> node_state;   ///< bit 0: fixed by a constraint; bit 1: in contact; bit 2: in a solid, apart

  /// If requested, Simulation::stable_step() of this state or of one less than 50 steps ago [s]; else 0.
  double stable_step = 0;

  std::vector<ProbeReading> probes;  ///< of the simulation's scene, where their particles are still there

  std::shared_ptr<const SceneView> scene;
  std::vector<Vec3> boundary_displacement;  ///< one a boundary, at report.time
  // The mouse's grab, if any.
  bool grabbed = false;
  Vec3 grab_at = Vec3::Zero();      ///< where the material is held [m]
  Vec3 grab_target = Vec3::Zero();  ///< where the mouse is [m]
  double grab_radius = 0;           ///< [m]

  /// Of the particle with this id, column-major; null: a cube.
  const float* domain_of(std::uint32_t of) const {
    const std::size_t size = static_cast<std::size_t>(dimension) * static_cast<std::size_t>(dimension), at = of * size;
    if (!domain || at + size > domain->size()) return nullptr;
    const float* const edges = domain->data() + at;
    return std::any_of(edges, edges + size, [](float e) { return e != 0; }) ? edges : nullptr;
  }
};

}  // namespace pf
