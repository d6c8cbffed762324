// B-splines of twice the spacing are sums of B-splines of the lattice itself: N(x / 2) = sum_k w_k N(x - k). The
// weights are the multigrid's prolongation, so a coarse level holds exactly the splines of a coarser grid.
#pragma once

#include <array>

namespace pf {

/// One axis, for splines of degree R (a reach of R): coarse point I is the sum of `children` points from
/// 2 I + first_child on.
template <int R>
struct TwoScale;
template <>
struct TwoScale<1> {
  static constexpr int children = 3, first_child = -1, parents = 2;
  static constexpr std::array<float, 3> weight{0.5f, 1, 0.5f};
};
template <>
struct TwoScale<2> {
  static constexpr int children = 4, first_child = -1, parents = 2;
  static constexpr std::array<float, 4> weight{0.25f, 0.75f, 0.75f, 0.25f};
};
template <>
struct TwoScale<3> {
  static constexpr int children = 5, first_child = -2, parents = 3;
  static constexpr std::array<float, 5> weight{0.125f, 0.5f, 0.75f, 0.5f, 0.125f};
};

/// The part that fine point i has in coarse point I; 0 where it has none.
template <int R>
constexpr float part_in(int i, int I) {
  const int k = i - 2 * I - TwoScale<R>::first_child;
  return k < 0 || k >= TwoScale<R>::children ? 0 : TwoScale<R>::weight[static_cast<std::size_t>(k)];
}
/// The first of the `parents` coarse points that fine point i may have a part in.
template <int R>
constexpr int first_parent(int i) {
  const int k = i >> 1;
  return part_in<R>(i, k - 1) > 0 ? k - 1 : k;
}

}  // namespace pf
