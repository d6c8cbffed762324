#include "core/scene/shapes/cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <future>

#include "core/scene/shapes/cell_cut.hpp"

namespace pf {
namespace {

Vec3 corner(std::size_t index) {
  return Vec3(static_cast<double>(index & 1), static_cast<double>(index >> 1 & 1), static_cast<double>(index >> 2 & 1));
}

/// How often the domain's sides hold `size`, rounded up; 1 in a direction that is not there.
std::array<int, 3> counts(const LevelSet& set, double size) {
  std::array<int, 3> n = {1, 1, 1};
  const Vec3 extent = set.domain.max - set.domain.min;
  for (int a = 0; a < set.dimension; ++a)
    n[static_cast<std::size_t>(a)] = std::max(1, static_cast<int>(std::ceil(extent[a] / size * (1 - 1e-9))));
  return n;
}

Vec3 cell_size(const LevelSet& set, const std::array<int, 3>& n) {
  const Vec3 extent = set.domain.max - set.domain.min;
  Vec3 size = Vec3::Zero();
  for (int a = 0; a < set.dimension; ++a) size[a] = extent[a] / n[static_cast<std::size_t>(a)];
  return size;
}

/// A tree of boxes, refined where the bound does not exclude the surface: costs what the surface does. `depth` counts
/// down to 0, the asked cell size.
class Tree {
 public:
  Tree(const LevelSet& set, CellCut& cut) : set_(set), cut_(cut) {}

  double run(int cells) {
    int depth = 0;
    while (depth < 5 && (8 << depth) < cells) ++depth;
    const double longest = (set_.domain.max - set_.domain.min).maxCoeff();
    const auto n = counts(set_, longest / std::ceil(cells / static_cast<double>(1 << depth)));
    const Vec3 size = cell_size(set_, n);
    double sum = 0;
    for (int k = 0; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j)
        for (int i = 0; i < n[0]; ++i) sum += cell(set_.domain.min + Vec3(i, j, k).cwiseProduct(size), size, depth);
    return sum;
  }

 private:
  static constexpr int extra_depth = 3;

  double cell(const Vec3& min, const Vec3& size, int depth) {
    const double d = set_.value(min + 0.5 * size);
    if (std::abs(d) > 0.5 * size.norm()) return d < 0 ? cut_.whole(min, size) : 0;
    const std::size_t n = std::size_t{1} << set_.dimension;
    if (depth <= 0) {
      CellCut::Values values{};
      double mean = 0;
      for (std::size_t c = 0; c < n; ++c) {
        values[c] = set_.value(min + corner(c).cwiseProduct(size));
        mean += values[c] / static_cast<double>(n);
      }
      // A distance is nearly linear in a cell, unless it holds an edge or two faces: those cells are split further.
      if (depth == -extra_depth || std::abs(mean - d) < 0.05 * size.norm()) return cut_.measure(min, size, values);
    }
    const Vec3 half = 0.5 * size;
    double sum = 0;
    for (std::size_t c = 0; c < n; ++c) sum += cell(min + corner(c).cwiseProduct(half), half, depth - 1);
    return sum;
  }

  const LevelSet& set_;
  CellCut& cut_;
};

/// All cells of a lattice, plane by plane, so that values come in rows.
class Lattice {
 public:
  Lattice(const LevelSet& set, int cells)
      : set_(set), n_(counts(set, (set.domain.max - set.domain.min).maxCoeff() / cells)), size_(cell_size(set, n_)) {}
  int layers() const { return n_[2]; }

  /// Of the layers from `first` on, before `last`.
  double run(CellCut& cut, int first, int last) const {
    std::vector<double> below = plane(first), above = below;
    double sum = 0;
    for (int k = first; k < last; ++k) {
      if (set_.dimension == 3) above = plane(k + 1);
      sum += layer(cut, k, below, above);
      below.swap(above);
    }
    return sum;
  }

 private:
  std::size_t row_size() const { return static_cast<std::size_t>(n_[0]) + 1; }
  std::size_t node(int i, int j) const {
    return static_cast<std::size_t>(j) * row_size() + static_cast<std::size_t>(i);
  }

  std::vector<double> plane(int k) const {
    std::vector<double> values(row_size() * (static_cast<std::size_t>(n_[1]) + 1));
    const Vec3 step(size_.x(), 0, 0);
    for (int j = 0; j <= n_[1]; ++j) {
      const Vec3 first = set_.domain.min + Vec3(0, j, k).cwiseProduct(size_);
      const auto row = std::span(values).subspan(node(0, j), row_size());
      if (set_.row) {
        set_.row(first, step, row);
      } else {
        for (std::size_t i = 0; i < row.size(); ++i) row[i] = set_.value(first + static_cast<double>(i) * step);
      }
    }
    return values;
  }

  double layer(CellCut& cut, int k, const std::vector<double>& below, const std::vector<double>& above) const {
    double sum = 0;
    for (int j = 0; j < n_[1]; ++j)
      for (int i = 0; i < n_[0]; ++i) {
        const std::size_t a = node(i, j), b = node(i, j + 1);
        const CellCut::Values values = {below[a], below[a + 1], below[b], below[b + 1],
                                        above[a], above[a + 1], above[b], above[b + 1]};
        sum += cut.measure(set_.domain.min + Vec3(i, j, k).cwiseProduct(size_), size_, values);
      }
    return sum;
  }

  const LevelSet& set_;
  std::array<int, 3> n_;
  Vec3 size_;
};

/// Two halves at a time, always the same two, so that the sum has the same bits on any machine.
double run_halves(const LevelSet& set, int cells) {
  const Lattice lattice(set, cells);
  const int middle = lattice.layers() / 2;
  const auto half = [&](int first, int last) {
    CellCut cut(set, nullptr);
    return lattice.run(cut, first, last);
  };
  if (middle == 0) return half(0, lattice.layers());
  std::future<double> upper = std::async(std::launch::async, half, middle, lattice.layers());
  const double lower = half(0, middle);
  return lower + upper.get();
}

double walk(const LevelSet& set, int cells, std::vector<SurfacePoint>* surface, Moments* moments = nullptr) {
  if (!(box_measure(set.domain.max - set.domain.min, set.dimension) > 0)) return 0;
  CellCut cut(set, surface, moments);
  if (set.is_bound) return Tree(set, cut).run(cells);
  if (!surface && !moments) return run_halves(set, cells);
  const Lattice lattice(set, cells);
  return lattice.run(cut, 0, lattice.layers());
}

}  // namespace

double inside_measure(const LevelSet& set, int cells) {
  return walk(set, cells, nullptr);
}

Moments inside_moments(const LevelSet& set, int cells) {
  Moments moments;
  walk(set, cells, nullptr, &moments);
  return moments;
}

void add_level_surface(const LevelSet& set, int cells, std::vector<SurfacePoint>& points) {
  walk(set, cells, &points);
}

}  // namespace pf
