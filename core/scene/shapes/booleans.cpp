#include "core/scene/shapes/cells.hpp"
#include "core/scene/shapes/shape_solid.hpp"

namespace pf {
namespace {

/// What union, intersection and difference share.
class Boolean : public ShapeSolid {
 public:
  Boolean(std::vector<SolidPointer> members, int dimension) : ShapeSolid(dimension), members_(std::move(members)) {}

  bool distance_is_bound() const override {
    return std::ranges::all_of(members_, [](const SolidPointer& m) { return m->distance_is_bound(); });
  }

  double measure(double h) const override {
    const Bounds b = bounds();
    if (!is_finite(b)) return std::numeric_limits<double>::infinity();
    // Members that only touch have distance 0 between them; the set is closed, so that counts as inside.
    const double closed = 1e-12 * (b.max - b.min).maxCoeff();
    const LevelSet set{[&](const Vec3& p) { return distance(p) - closed; }, nullptr, distance_is_bound(), b,
                       dimension()};
    const double wanted = (b.max - b.min).maxCoeff() / h;
    const bool flat_domain = dimension() == 2;
    // A tree is refined only along the surface, so that it can afford more.
    const double least = flat_domain ? (set.is_bound ? 1024 : 512) : 96;
    const double most = set.is_bound ? (flat_domain ? 8192 : 192) : least;
    return inside_measure(set, static_cast<int>(std::clamp(std::ceil(2 * wanted), least, most)));
  }

 protected:
  using Points = std::vector<SurfacePoint>;
  const std::vector<SolidPointer>& members() const { return members_; }

  Points member_surface(std::size_t i, double h, const Bounds& clip) const {
    Points points;
    members_[i]->add_surface(h, clip, points);
    return points;
  }
  /// An earlier member has its surface here too, facing the same way: its own points stand for both.
  bool repeats(std::size_t i, const SurfacePoint& s, double epsilon, double first_sign = 1) const {
    for (std::size_t j = 0; j < i; ++j) {
      const double sign = j == 0 ? 1 : first_sign;
      if (std::abs(members_[j]->distance(s.position)) < 2 * epsilon &&
          sign * members_[j]->normal(s.position).dot(s.normal) > 1 - 1e-6)
        return true;
    }
    return false;
  }
  static double small(double h) { return 1e-6 * h; }

 private:
  std::vector<SolidPointer> members_;
};

class Union final : public Boolean {
 public:
  using Boolean::Boolean;

  bool contains(const Vec3& p, double tolerance) const override {
    return std::ranges::any_of(members(), [&](const SolidPointer& m) { return m->contains(p, tolerance); });
  }
  double distance(const Vec3& p) const override { return nearest(p).distance(p); }
  Vec3 normal(const Vec3& p) const override { return nearest(p).normal(p); }

  void contact_normals(const Vec3& p, bool inverted, double tolerance, std::vector<Vec3>& normals) const override {
    if (inverted) {  // outside of all: the nearest is the face to pass
      nearest(p).contact_normals(p, true, tolerance, normals);
      return;
    }
    const std::size_t first = normals.size();
    for (const SolidPointer& m : members()) m->contact_normals(p, false, tolerance, normals);
    drop_repeated(normals, first);
  }

  Bounds bounds() const override {
    Bounds b = members()[0]->bounds();
    for (const SolidPointer& m : members()) {
      const Bounds other = m->bounds();
      b = {b.min.cwiseMin(other.min), b.max.cwiseMax(other.max)};
    }
    return b;
  }

  void add_surface(double h, const Bounds& clip, Points& points) const override {
    for (std::size_t i = 0; i < members().size(); ++i)
      for (const SurfacePoint& s : member_surface(i, h, clip)) {
        const Vec3 out = s.position + small(h) * s.normal;
        bool free = !repeats(i, s, small(h));
        for (std::size_t j = 0; free && j < members().size(); ++j) free = j == i || members()[j]->distance(out) > 0;
        if (free) points.push_back(s);
      }
  }

 private:
  const Solid& nearest(const Vec3& p) const {
    return **std::ranges::min_element(members(), {}, [&](const SolidPointer& m) { return m->distance(p); });
  }
};

class Intersection final : public Boolean {
 public:
  using Boolean::Boolean;

  bool contains(const Vec3& p, double tolerance) const override {
    return std::ranges::all_of(members(), [&](const SolidPointer& m) { return m->contains(p, tolerance); });
  }
  double distance(const Vec3& p) const override { return farthest(p).distance(p); }
  Vec3 normal(const Vec3& p) const override { return farthest(p).normal(p); }

  void contact_normals(const Vec3& p, bool inverted, double tolerance, std::vector<Vec3>& normals) const override {
    if (!inverted) {
      if (contains(p, tolerance)) farthest(p).contact_normals(p, false, tolerance, normals);
      return;
    }
    const std::size_t first = normals.size();
    for (const SolidPointer& m : members()) m->contact_normals(p, true, tolerance, normals);
    drop_repeated(normals, first);
  }

  Bounds bounds() const override {
    Bounds b = members()[0]->bounds();
    for (const SolidPointer& m : members()) {
      const Bounds other = m->bounds();
      b = {b.min.cwiseMax(other.min), b.max.cwiseMin(other.max)};
    }
    b.max = b.max.cwiseMax(b.min);  // nothing in common: no extent
    return b;
  }

  void add_surface(double h, const Bounds& clip, Points& points) const override {
    const Bounds own = bounds();
    const Bounds part{clip.min.cwiseMax(own.min), clip.max.cwiseMin(own.max)};
    for (std::size_t i = 0; i < members().size(); ++i)
      for (const SurfacePoint& s : member_surface(i, h, part)) {
        const Vec3 in = s.position - small(h) * s.normal;
        bool free = !repeats(i, s, small(h));
        for (std::size_t j = 0; free && j < members().size(); ++j) free = j == i || members()[j]->distance(in) < 0;
        if (free) points.push_back(s);
      }
  }

 private:
  const Solid& farthest(const Vec3& p) const {
    return **std::ranges::max_element(members(), {}, [&](const SolidPointer& m) { return m->distance(p); });
  }
};

class Difference final : public Boolean {
 public:
  using Boolean::Boolean;

  bool contains(const Vec3& p, double tolerance) const override {
    return members()[0]->contains(p, tolerance) &&
           std::all_of(members().begin() + 1, members().end(),
                       [&](const SolidPointer& m) { return m->distance(p) >= -tolerance; });
  }
  double distance(const Vec3& p) const override {
    const std::size_t i = farthest(p);
    return sign(i) * members()[i]->distance(p);
  }
  Vec3 normal(const Vec3& p) const override {
    const std::size_t i = farthest(p);
    return sign(i) * members()[i]->normal(p);
  }

  void contact_normals(const Vec3& p, bool inverted, double tolerance, std::vector<Vec3>& normals) const override {
    if (!inverted) {  // the nearest face may be the wall of a hole
      const std::size_t i = farthest(p);
      if (contains(p, tolerance)) members()[i]->contact_normals(p, i > 0, tolerance, normals);
      return;
    }
    const std::size_t first = normals.size();
    for (std::size_t i = 0; i < members().size(); ++i) members()[i]->contact_normals(p, i == 0, tolerance, normals);
    drop_repeated(normals, first);
  }

  Bounds bounds() const override { return members()[0]->bounds(); }

  void add_surface(double h, const Bounds& clip, Points& points) const override {
    const Bounds own = bounds();
    const Bounds part{clip.min.cwiseMax(own.min), clip.max.cwiseMin(own.max)};
    for (std::size_t i = 0; i < members().size(); ++i)
      for (SurfacePoint s : member_surface(i, h, part)) {
        s.normal *= sign(i);
        const Vec3 in = s.position - small(h) * s.normal;
        bool free = !repeats(i, s, small(h), -1);
        for (std::size_t j = 0; free && j < members().size(); ++j)
          free = j == i || sign(j) * members()[j]->distance(in) < 0;
        if (free) points.push_back(s);
      }
  }

 private:
  static double sign(std::size_t i) { return i == 0 ? 1 : -1; }
  /// The member whose surface is nearest from inside: largest of d_0, -d_1, -d_2, ...
  std::size_t farthest(const Vec3& p) const {
    std::size_t best = 0;
    double largest = members()[0]->distance(p);
    for (std::size_t i = 1; i < members().size(); ++i) {
      const double d = -members()[i]->distance(p);
      if (d > largest) {
        largest = d;
        best = i;
      }
    }
    return best;
  }
};

}  // namespace

SolidPointer make_union(std::vector<SolidPointer> members, int dimension) {
  return std::make_unique<Union>(std::move(members), dimension);
}
SolidPointer make_intersection(std::vector<SolidPointer> members, int dimension) {
  return std::make_unique<Intersection>(std::move(members), dimension);
}
SolidPointer make_difference(std::vector<SolidPointer> members, int dimension) {
  return std::make_unique<Difference>(std::move(members), dimension);
}

}  // namespace pf
