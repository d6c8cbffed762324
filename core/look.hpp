// Looking inside a running simulation: a particle with the nodes that it meets, a node with the particles that it
// meets, at the newest state. Plain values; nothing is computed unless somebody asks (Simulation::look).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/bases/basis.hpp"
#include "core/simulation.hpp"

namespace pf {

/// Lattice coordinates of a node, x_i = dx * index; the third is 0 in 2D.
using NodeIndex = std::array<std::int32_t, 3>;

/// A node and its shape function at one point (THEORY T2).
struct NodeWeight {
  NodeIndex node{};
  double w = 0;              ///< N_i(x) = w_ip
  Vec3 grad = Vec3::Zero();  ///< grad N_i(x) [1/m]
};
/// All nodes of the point's stencil, x fastest: (k+1)^dimension of them.
std::vector<NodeWeight> weights_at(const BasisInfo& basis, double spacing, int dimension, const Vec3& x);

/// The same of a particle in a step recorded at RecordLevel::all (its place in the record's arrays), as the step had
/// them; to single precision. Empty where the record has none.
std::vector<NodeWeight> recorded_weights(const StepRecord& record, std::size_t particle);

/// A particle at t^n, and the nodes that the coming step will join it to.
struct ParticleLook {
  ParticleState state;
  double J = 1;
  Vec3 stretches = Vec3::Ones();  ///< singular values of F, the largest first; the last is 1 in 2D
  double energy = 0;              ///< V_p^0 psi [J]
  std::vector<NodeWeight> nodes;
  double weight_sum = 0;             ///< sum_i w_ip: 1
  Vec3 gradient_sum = Vec3::Zero();  ///< sum_i grad w_ip: 0 [1/m]
  Vec3 position_sum = Vec3::Zero();  ///< sum_i w_ip x_i: x_p [m]
};

/// What one particle gives to a node.
struct Contribution {
  std::uint32_t particle = 0;    ///< id
  double w = 0;                  ///< w_ip
  double mass = 0;               ///< m_p w_ip [kg]
  Vec3 momentum = Vec3::Zero();  ///< m_p w_ip v_p, with APIC's affine part [kg m/s]
  Vec3 force = Vec3::Zero();     ///< - V_p^0 P F_p^T grad w_ip [N]
};

/// A node at t^n: what the coming step will find there.
struct NodeLook {
  NodeIndex node{};
  Vec3 x = Vec3::Zero();         ///< [m]
  bool active = false;           ///< some particle lies in its support; else all below is 0
  double mass = 0;               ///< m_i [kg]
  Vec3 velocity = Vec3::Zero();  ///< sum_p m_p w_ip v_p / m_i: of the lumped velocity transfer [m/s]
  Vec3 internal = Vec3::Zero();  ///< f_i^int(x) [N]
  Vec3 external = Vec3::Zero();  ///< f_i^ext(t) [N]
  std::size_t contributors = 0;
  std::vector<Contribution> largest;  ///< by mass, the most first; at most `most_contributions` of them
  /// What the solve of the newest step left here, where that step was recorded and the node took part [N].
  std::optional<Vec3> residual;
};
inline constexpr std::size_t most_contributions = 32;

struct LookQuestion {
  std::optional<std::uint32_t> particle;  ///< id
  std::optional<NodeIndex> node;
  bool operator==(const LookQuestion&) const = default;
};
struct Look {
  long step = -1;  ///< of the state that was looked at
  double time = 0;
  std::optional<ParticleLook> particle;
  std::optional<NodeLook> node;
};

}  // namespace pf
