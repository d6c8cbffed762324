// Shape functions of the background grid, one direction at a time (THEORY T2): N_i(x) is the product over the axes.
#pragma once

#include <span>
#include <string_view>

namespace pf {

inline constexpr int max_nodes_per_axis = 4;

/// Several numbers of s at once, one a particle.
typedef double FourNumbers __attribute__((vector_size(32)));   // NOLINT: the attribute needs a typedef
typedef double EightNumbers __attribute__((vector_size(64)));  // NOLINT: the same

/// A tensor-product basis. `weights(s, base, N, dN)`: s = x/dx; the nodes base, base + 1, ... (nodes_per_axis of
/// them) have N_r = N(s - base - r) and dN_r = N'(s - base - r) (per unit of s: divide by dx).
struct BasisInfo {
  std::string_view name;   ///< as in the scene file
  std::string_view label;  ///< plain name
  std::string_view about;
  int nodes_per_axis;
  /// D_p = sum N (x_j - x_p)(x)(x_j - x_p) is a positive constant times dx^2 (quadratic, cubic); for the linear basis
  /// it is singular and APIC takes its affine part from grad N (THEORY T5).
  bool affine_by_moments;
  void (*weights)(double s, long long& base, double* N, double* dN);
  /// base = floor(s - offset).
  double offset;
  /// D_p / dx^2 where affine_by_moments.
  double moment;
  /// The same weights of particles whose base is known, all axes at once: t = s - base of each axis; nodes_per_axis
  /// values an axis. `four`: two axes, `eight`: three.
  void (*four)(const FourNumbers* t, FourNumbers* N, FourNumbers* dN);
  void (*eight)(const EightNumbers* t, EightNumbers* N, EightNumbers* dN);
  /// Of bases that are averaged over the particle's own domain (core/grid/domain.hpp); null: sampled at its centre.
  /// One axis: the means of N and N' over [t - width/2, t + width/2], width > 0, which must not reach beyond
  /// [offset - 1/2, offset + 3/2]. `weights`, `four` and `eight` are then those of the spline itself, among as many
  /// nodes.
  void (*mean_four)(const FourNumbers& t, const FourNumbers& width, FourNumbers* N, FourNumbers* dN) = nullptr;
  void (*mean_eight)(const EightNumbers& t, const EightNumbers& width, EightNumbers* N, EightNumbers* dN) = nullptr;
  bool averaged() const { return mean_four != nullptr; }
  /// Does not interpolate at nodes: at walls its functions can be changed so that they do (core/grid/edges.hpp).
  bool bends = false;
};

/// `values` (t, N, dN) of one axis, for each axis.
template <int axes, int nodes, class T, void (*values)(const T&, T*, T*)>
void all_axes(const T* t, T* N, T* dN) {
  for (int a = 0; a < axes; ++a) values(t[a], N + a * nodes, dN + a * nodes);
}

/// Every basis, in the order in which it is offered.
std::span<const BasisInfo> bases();
/// nullptr when no basis has this name.
const BasisInfo* find_basis(std::string_view name);

}  // namespace pf
