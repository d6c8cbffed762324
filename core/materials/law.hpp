// What a constitutive law is to the rest of the program: psi(F), P(F), dP/dF (THEORY T1, T3).
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/types.hpp"

namespace pf {

/// One parameter of a law, as it stands in the scene file beside "model" and "density".
struct LawParameter {
  std::string_view key;    ///< for instance "young"
  std::string_view label;  ///< plain name, for instance "Young's modulus"
  std::string_view unit;   ///< SI, "" when dimensionless
  double min, max;         ///< allowed range; the ends are excluded where `open_min`, `open_max`
  bool open_min, open_max;
  double typical;  ///< where a slider starts; there is no silent default in a scene
  std::string_view help;
};

/// What is known of a law without an instance of it.
struct LawInfo {
  std::string_view name;   ///< as in the scene file
  std::string_view label;  ///< plain name for the interface
  std::string_view about;  ///< one sentence: when to use it, formula, source
  std::vector<LawParameter> parameters;
  bool objective;        ///< psi(RF) = psi(F) for rotations R
  bool barrier_at_zero;  ///< psi -> infinity as J -> 0+: the line search keeps J > 0
};

/// Components of the upper half of a Tangent<D>, stored row by row: (0,0) (0,1) ... (1,1) ...
template <int D>
inline constexpr int tangent_components = D* D*(D* D + 1) / 2;
/// Position there of component (row, column), row <= column.
template <int D>
constexpr int packed_tangent_index(int row, int column) {
  return row * D * D - row * (row - 1) / 2 + (column - row);
}

/// A hyperelastic law. `F` is the deformation gradient, D x D; in 2D the motion is plane strain, F_33 = 1.
/// Energies are per unit reference volume [J/m^3 = Pa], stresses are first Piola-Kirchhoff [Pa].
/// All spans of a call have equal length; each call handles a batch so that the virtual call is paid once.
/// Where `barrier_at_zero`, det F <= 0 gives psi = +infinity (and unspecified P); nothing throws.
template <int D>
class Law {
 public:
  virtual ~Law() = default;
  virtual const LawInfo& info() const = 0;
  /// psi_p = psi(F_p).
  virtual void energy(std::span<const Mat<D>> F, std::span<double> psi) const = 0;
  /// psi_p and P_p = dpsi/dF(F_p).
  virtual void stress(std::span<const Mat<D>> F, std::span<double> psi, std::span<Mat<D>> P) const = 0;
  /// dP_p/dF_p, symmetric; with `project`, the nearest positive semi-definite matrix (Frobenius norm).
  virtual void tangent(std::span<const Mat<D>> F, bool project, std::span<Tangent<D>> dP) const = 0;
  /// The same as Newton's matrix needs it (THEORY T4): weight_p d2psi/dF^dF^ at F = F^ F_n, that is
  /// weight_p (F_n (x) I) dP/dF (F_n (x) I)^T. Component packed_tangent_index(row, column) of particle p goes to
  /// place[p][index * stride]; particles whose places follow one another are stored together. Single precision: the
  /// matrix is what conjugate gradients stream from memory, and Newton's method ends where the residual, in double,
  /// does. What `project` makes stays positive semi-definite when it is rounded.
  virtual void grid_tangent(std::span<const Mat<D>> F, std::span<const Mat<D>> F_n, std::span<const double> weight,
                            bool project, std::span<float* const> place, int stride) const = 0;
  /// Cauchy stress sigma = P F^T / J as full 3 x 3 tensors [Pa]; in 2D sigma_zz of plane strain included.
  virtual void cauchy(std::span<const Mat<D>> F, std::span<Mat3> sigma) const = 0;
  /// The same of one particle; a batch costs a third to an eighth of that a particle.
  Mat3 cauchy(const Mat<D>& F) const {
    Mat3 sigma;
    cauchy({&F, 1}, {&sigma, 1});
    return sigma;
  }
  /// Speed of pressure waves in the undeformed material, sqrt((lambda + 2 mu)/rho) [m/s].
  virtual double wave_speed(double density) const = 0;
  /// mu of the undeformed material [Pa].
  virtual double shear_modulus() const = 0;

  /// Whether particles of a cell share their change of volume in a step (F-bar, core/energies/volume_patches.hpp): the
  /// material's choice. The functions above know nothing of it.
  bool shares_volume() const { return shares_volume_; }
  void share_volume(bool on) { shares_volume_ = on; }

 private:
  bool shares_volume_ = false;
};

/// Every law, in the order in which it is offered.
std::span<const LawInfo> laws();
/// nullptr when no law has this name.
const LawInfo* find_law(std::string_view name);
/// `parameters` in the order of LawInfo::parameters, already checked against their ranges. Throws
/// std::invalid_argument for an unknown name.
template <int D>
std::unique_ptr<Law<D>> make_law(std::string_view name, std::span<const double> parameters);

extern template std::unique_ptr<Law<2>> make_law<2>(std::string_view, std::span<const double>);
extern template std::unique_ptr<Law<3>> make_law<3>(std::string_view, std::span<const double>);

}  // namespace pf
