// A box with the surface { value = 0 } in it: how much of it lies inside, and the surface's piece.
#pragma once

#include <array>
#include <cstdint>

#include "core/scene/shapes/cells.hpp"
#include "core/scene/shapes/moments.hpp"

namespace pf {

/// Splits the box into two triangles or six tetrahedra and cuts each by a plane through the points where the surface
/// crosses its edges.
class CellCut {
 public:
  /// Values at the corners of a box; bits 0, 1, 2 of the index say which end in x, y, z.
  using Values = std::array<double, 8>;

  /// `surface` may be nullptr; else a point a cut cell is appended. `moments` may be nullptr; else those of all that
  /// lies inside are added.
  CellCut(const LevelSet& set, std::vector<SurfacePoint>* surface, Moments* moments = nullptr)
      : set_(set), surface_(surface), moments_(moments) {}

  /// The measure of the inside in [min, min + size].
  double measure(const Vec3& min, const Vec3& size, const Values& values);
  /// Of a box that is known to lie inside.
  double whole(const Vec3& min, const Vec3& size);

 private:
  struct Corner {
    int index;
    double value;
    bool inside() const { return value < 0; }
  };

  void triangle(std::array<Corner, 3> c);
  void tetrahedron(std::array<Corner, 4> c);
  Vec3 at(const Corner& c) const;
  /// Adds a simplex to what lies inside.
  template <class... Corner>
  void add_inside(double measure, const Corner&... corners) {
    inside_ += measure;
    if (moments_) moments_->add_simplex(measure, corners...);
  }
  /// Where the surface cuts the edge from an inner to an outer corner; found once a cell.
  Vec3 crossing(const Corner& in, const Corner& out);
  Vec3 find_crossing(const Corner& in, const Corner& out) const;
  /// `outside`: a point on the side that the normal shall point to.
  void add_triangle(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& outside);
  /// `normal`: as long as the piece is large.
  void add_piece(const Vec3& at, const Vec3& normal);

  const LevelSet& set_;
  std::vector<SurfacePoint>* surface_;
  Moments* moments_;
  Vec3 min_ = Vec3::Zero(), size_ = Vec3::Zero();
  double inside_ = 0;                                   // of the present cell
  double area_ = 0;                                     // of the surface in it
  Vec3 moment_ = Vec3::Zero(), normal_ = Vec3::Zero();  // area times centre, area times normal
  std::uint64_t known_ = 0;  // bit 8 i + j: the crossing between corners i and j has been found
  std::array<Vec3, 64> crossing_;
};

}  // namespace pf
