// Moments of a piece of space up to the second: what a quadrature point must have to integrate quadratic functions over
// the piece exactly.
#pragma once

#include "core/types.hpp"

namespace pf {

/// Sums over boxes and simplices; about the origin. In 2D all z are 0.
struct Moments {
  double measure = 0;          ///< [m^d]
  Vec3 first = Vec3::Zero();   ///< integral of x [m^(d+1)]
  Mat3 second = Mat3::Zero();  ///< integral of x x^T [m^(d+2)]

  void add(const Moments& other) {
    measure += other.measure;
    first += other.first;
    second += other.second;
  }
  void add_box(const Vec3& min, const Vec3& size, int dimension) {
    const double V = size.x() * size.y() * (dimension == 3 ? size.z() : 1);
    const Vec3 c = min + 0.5 * size;
    measure += V;
    first += V * c;
    second += V * (c * c.transpose());
    second.diagonal() += V / 12 * size.cwiseAbs2();
  }
  /// A triangle (2D) or tetrahedron of this measure, which may be negative. Of a simplex with corners c_k:
  /// integral of x x^T = V / ((d+1)(d+2)) (sum c_k c_k^T + s s^T), s = sum c_k.
  template <class... Corner>
  void add_simplex(double V, const Corner&... corners) {
    constexpr double n = sizeof...(corners);
    const Vec3 s = (corners + ...);
    const Mat3 squares = ((corners * corners.transpose()) + ...);
    measure += V;
    first += V / n * s;
    second += V / (n * (n + 1)) * (squares + s * s.transpose());
  }

  /// The same piece, moved by `way`.
  Moments moved(const Vec3& way) const {
    const Mat3 mixed = way * first.transpose();
    return {measure, first + measure * way,
            Mat3(second + mixed + mixed.transpose() + measure * (way * way.transpose()))};
  }
  Vec3 centre() const { return first / measure; }
  /// Of a point drawn evenly from the piece: integral of (x - c)(x - c)^T over the measure.
  Mat3 covariance() const { return second / measure - centre() * centre().transpose(); }
};

}  // namespace pf
