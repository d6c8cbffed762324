// The part of a straight line that lies in a rectangle.
#pragma once

#include <algorithm>

namespace pf {

/// The stretch [t0, t1] of a + t (b - a), t in [0, 1], inside the rectangle (Liang and Barsky 1984). False: none.
inline bool clip_segment(double ax, double ay, double bx, double by, double min_x, double min_y, double max_x,
                         double max_y, double& t0, double& t1) {
  t0 = 0;
  t1 = 1;
  const auto cut = [&](double p, double q) {
    if (p == 0) return q >= 0;
    const double t = q / p;
    if (p < 0) t0 = std::max(t0, t);
    if (p > 0) t1 = std::min(t1, t);
    return t0 <= t1;
  };
  const double dx = bx - ax, dy = by - ay;
  return cut(-dx, ax - min_x) && cut(dx, max_x - ax) && cut(-dy, ay - min_y) && cut(dy, max_y - ay);
}

}  // namespace pf
