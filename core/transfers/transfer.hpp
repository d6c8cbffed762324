// Particles <-> grid (THEORY T3, T5). The position and F updates are the same for all; a transfer decides what the
// grid's velocity does to the particles' and back.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <string_view>

#include "core/grid/mass.hpp"
#include "core/grid/plan.hpp"

namespace pf {

/// What the grid carries during a step; D components a node where it is a vector.
template <int D>
struct GridState {
  Vector mass;      ///< m_i, one a node [kg]
  Vector momentum;  ///< sum_p m_p N_i (v_p + ...) [kg m/s]
  Vector v;         ///< v_i^n [m/s]
  Vector u;         ///< x^_i - x_i [m]
  Vector v_end;     ///< v_i^{n+1} [m/s]
  // Of time schemes that carry an acceleration; empty where there is none (yet).
  Vector a, a_end;  ///< a_i^n, a_i^{n+1} [m/s^2]
  Vector sums;      ///< momentum and mass as they are gathered, D + 1 a node
};

/// Extremes that decide whether a state may stand.
struct StateCheck {
  bool finite = true;
  double min_J = 1, max_J = 1, max_speed = 0;

  void include(const StateCheck& other) {
    finite = finite && other.finite;
    min_J = std::min(min_J, other.min_J);
    max_J = std::max(max_J, other.max_J);
    max_speed = std::max(max_speed, other.max_speed);
  }
};

template <int D>
class Transfer {
 public:
  virtual ~Transfer() = default;
  /// True: particles carry an affine velocity C, which takes part in P2G and in the balances.
  virtual bool affine() const = 0;
  /// Terms of the series for M^-1 by which momenta become node velocities (sharpen_velocity); 1: the lumped mass alone.
  virtual int order() const { return 1; }
  /// The particles' v, C and F_p = (I + sum_j u_j (x) grad N_j) F_p^n after the step (THEORY T5), at their old
  /// positions: to.x is left alone. What comes of it, if F is asked for.
  virtual StateCheck grid_to_particles(const Plan<D>& plan, const GridState<D>& grid, const Particles<D>& particles,
                                       Parallel& parallel, const Motion<D>& to) const = 0;
  /// The momenta that come back from particles which took nothing but node velocities v: m_i (S v)_i [kg m/s], where S
  /// averages; m S is symmetric, the eigenvalues of S lie in [0, 1].
  virtual void carry(const Plan<D>& plan, const Particles<D>& particles, const Vector& v, Parallel& parallel,
                     Vector& momentum) const = 0;
  /// What averaging does to the limit of explicit steps: a mode of which S leaves s counts as if its frequency squared
  /// were this many times as large (docs/failures.md). 1 where s = 1, up to 2 where s = 0.
  virtual double stiffening(double s) const = 0;
};

/// m_i and momentum; nodes that receive no mass get the mean velocity of the particles around them in `v` later.
template <int D>
void particles_to_grid(const Plan<D>& plan, const Particles<D>& particles, bool affine, Parallel& parallel,
                       GridState<D>& grid);
/// v_i = momentum / m_i; where m_i is nothing but rounding, the mean of the particles that the node's gradient sees.
template <int D>
void lumped_velocity(const Plan<D>& plan, const Particles<D>& particles, GridState<D>& grid);
/// What a constraint prescribes of a node's velocity or acceleration.
template <int D>
struct HeldNode {
  std::int32_t node = 0;
  Mat<D> free = Mat<D>::Zero();   ///< projector on the directions that are not prescribed
  Vec<D> value = Vec<D>::Zero();  ///< in the others (free * value = 0) [m/s or m/s^2]
};
/// FMPM(k) (Nairn and Hammerquist 2021): v becomes sum_{j<k} (I - m^-1 M)^j v, where v = m^-1 P is the lumped velocity
/// and M the consistent mass. m^-1 M averages, its eigenvalues lie in [0, 1]: a step loses (1 - s)^k of a mode instead
/// of 1 - s; the limit is the consistent velocity transfer. Nodes whose mass is rounding keep the velocity they have.
/// What is held takes its value at once and no part in the series, which then inverts M of the free directions: grid
/// velocities that a step has left with these values are a fixed point of transfer and series (k to infinity).
template <int D>
void sharpen_velocity(const MassMatrix<D>& M, int order, Vector& v, const std::vector<HeldNode<D>>& held = {});
/// values_p = sum_j N_j(x_p) field_j.
template <int D>
void gather_field(const Plan<D>& plan, const Vector& field, Parallel& parallel, std::vector<Vec<D>>& values);
/// field_i += sum_p N_i(x_p) values_p.
template <int D>
void scatter_field(const Plan<D>& plan, const std::vector<Vec<D>>& values, Parallel& parallel, Vector& field);
/// D_p = sum_j N_j (x_j - x_p)(x)(x_j - x_p) at x: diagonal for a tensor-product basis that reproduces linear fields.
template <int D>
Vec<D> affine_inertia(const BasisInfo& basis, double spacing, const Vec<D>& x);
/// The same of a block's particles, one after the other; not diagonal where domains rotate and shear.
template <int D>
void affine_inertias(const Plan<D>& plan, const Particles<D>& particles, const Block<D>& block, Mat<D>* inertia);

struct TransferInfo {
  std::string_view name, label, about;
};
std::span<const TransferInfo> transfers();
/// `order`: of FMPM. Throws std::invalid_argument for an unknown name.
template <int D>
std::unique_ptr<Transfer<D>> make_transfer(std::string_view name, double flip_ratio, int order = 2);

}  // namespace pf
