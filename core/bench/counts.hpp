// What kernels must move and compute, counted from their loops: bytes are what has to come from or go to memory at
// least once when nothing stays in a cache between two calls; flops count a fused multiply-add as two.
#pragma once

#include "core/materials/law.hpp"

namespace pf::bench {

struct Counts {
  double bytes = 0, flops = 0;  ///< a particle
};
inline Counts operator+(Counts a, Counts b) {
  return {a.bytes + b.bytes, a.flops + b.flops};
}

/// Multiply-adds of one gather or scatter of C components over K nodes an axis with gradients, axis by axis.
inline double stencil_flops(int D, int K, int C, bool value, bool gradient) {
  const double rows = D == 3 ? K * K : K;
  double fused = rows * K * (gradient ? 2 : 1);        // along x
  fused += (D == 3 ? K : 1) * K * (gradient ? 3 : 1);  // along y
  if (D == 3) fused += K * ((gradient ? 3 : 0) + (value || gradient ? 1 : 0));
  return 2 * C * fused;
}

/// What the weights of a particle are computed from: its place in its cell.
inline double weight_bytes(int D) {
  return 8.0 * D;
}
inline double vector_bytes(int D) {
  return 8.0 * D;
}
inline double matrix_bytes(int D) {
  return 8.0 * D * D;
}

}  // namespace pf::bench
