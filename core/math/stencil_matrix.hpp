// A sparse symmetric matrix of D x D blocks whose pattern is a stencil on a lattice: the lower half by rows, in single
// precision, without column indices. For preconditioners, which need not be exact.
#pragma once

#include <new>

#include "core/math/stencil_layout.hpp"

namespace pf {

/// Floats of a window of 2 R + 1 points, filled up to whole vectors.
template <int D, int R>
inline constexpr int window_width = ((2 * R + 1) * D + 7) / 8 * 8;

/// Memory that starts at a cache line.
template <class T>
struct LineAllocator {
  using value_type = T;
  LineAllocator() = default;
  template <class U>
  LineAllocator(const LineAllocator<U>&) {}  // NOLINT: allocators convert
  T* allocate(std::size_t n) { return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{64})); }
  void deallocate(T* p, std::size_t) { ::operator delete (p, std::align_val_t{64}); }
  template <class U>
  bool operator==(const LineAllocator<U>&) const {
    return true;
  }
};
using Floats = std::vector<float, LineAllocator<float>>;

/// A row holds, for each line of the lower half and each a, `width` floats: entry (a, c) of the block of the window's
/// point k at D k + c. The row's own line holds the points before it only; diagonal blocks (column-major) stand apart.
template <int D>
struct StencilMatrix {
  const StencilLayout<D>* layout = nullptr;
  int width = 0;
  Floats lower, diagonal;

  void shape(const StencilLayout<D>& of) {
    layout = &of;
    width = ((2 * of.reach() + 1) * D + 7) / 8 * 8;
    lower.assign(static_cast<std::size_t>(of.rows()) * row_size(), 0);
    diagonal.assign(static_cast<std::size_t>(of.rows()) * D * D, 0);
  }
  std::size_t row_size() const {
    return static_cast<std::size_t>(layout->lines()) * static_cast<std::size_t>(D * width);
  }
  float* row(int i) { return lower.data() + static_cast<std::size_t>(i) * row_size(); }
  const float* row(int i) const { return lower.data() + static_cast<std::size_t>(i) * row_size(); }
  float* diagonal_block(int i) { return diagonal.data() + static_cast<std::size_t>(i) * D * D; }
  const float* diagonal_block(int i) const { return diagonal.data() + static_cast<std::size_t>(i) * D * D; }
};

/// Calls f(std::integral_constant<int, R>) for a reach of 1 to 3.
template <class Function>
decltype(auto) with_reach(int reach, Function&& f) {
  switch (reach) {
    case 1:
      return f(std::integral_constant<int, 1>{});
    case 2:
      return f(std::integral_constant<int, 2>{});
    default:
      return f(std::integral_constant<int, 3>{});
  }
}

/// Short vectors by the compilers' vector extension.
template <int count>
struct FloatsOf {
  typedef float type __attribute__((vector_size(count * 4)));  // NOLINT: the attribute needs a typedef
};
template <int count>
using FloatLanes = typename FloatsOf<count>::type;
/// How many floats of a window are worked on at a time.
template <int width>
inline constexpr int window_lanes = width % 16 == 0 ? 16 : 8;

}  // namespace pf
