#include "render/hidden.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/camera.hpp"

namespace pf {

namespace {

constexpr float full = 0.75f;                // share of a cell
constexpr std::size_t most_cells = 1 << 22;  // of the box around all bodies

struct Cells {
  Vec3 low;
  double spacing = 1;
  std::array<std::size_t, 3> count{};
  std::size_t stride(int axis) const { return axis == 0 ? 1 : axis == 1 ? count[0] : count[0] * count[1]; }
  std::size_t size() const { return count[0] * count[1] * count[2]; }
  std::size_t of(const double* x) const {
    std::size_t cell = 0;
    for (int a = 0; a < 3; ++a) cell += stride(a) * static_cast<std::size_t>((x[a] - low[a]) / spacing);
    return cell;
  }
};

/// A border of one empty cell lies around all particles.
Cells cells_around(const Snapshot& s) {
  Cells cells;
  const ViewBounds bounds = particle_bounds(s);
  cells.spacing = s.spacing;
  double total = 1;
  for (int a = 0; a < 3; ++a) {
    const double first = std::floor(bounds.min[a] / s.spacing) - 1, last = std::floor(bounds.max[a] / s.spacing) + 1;
    cells.low[a] = first * s.spacing;
    cells.count[static_cast<std::size_t>(a)] = static_cast<std::size_t>(std::min(last - first + 1, 1e7));
    total *= last - first + 1;
  }
  if (!(total <= static_cast<double>(most_cells))) cells.count = {};
  return cells;
}

/// 1 where the least of a cell and its two neighbours along `axis` is.
void erode(std::vector<std::uint8_t>& flags, const Cells& cells, int axis) {
  const std::size_t step = cells.stride(axis);
  std::vector<std::uint8_t> out(flags.size(), 0);
  for (std::size_t c = step; c + step < flags.size(); ++c) out[c] = flags[c - step] & flags[c] & flags[c + step];
  flags.swap(out);
}

}  // namespace

std::vector<std::uint8_t> hidden_particles(const Snapshot& s) {
  if (s.dimension != 3 || s.particles == 0 || s.F.size() < 9 * s.particles || s.volume0.size() < s.particles ||
      !(s.spacing > 0))
    return {};
  const Cells cells = cells_around(s);
  if (cells.size() == 0) return {};
  std::vector<float> volume(cells.size(), 0.f);
  std::vector<std::size_t> cell(s.particles);
  for (std::size_t p = 0; p < s.particles; ++p) {
    cell[p] = cells.of(&s.x[3 * p]);
    const float* f = &s.F[9 * p];
    const float J =
        f[0] * (f[4] * f[8] - f[5] * f[7]) - f[3] * (f[1] * f[8] - f[2] * f[7]) + f[6] * (f[1] * f[5] - f[2] * f[4]);
    if (cell[p] < volume.size()) volume[cell[p]] += s.volume0[p] * std::max(J, 0.f);
  }
  const float least = full * static_cast<float>(s.spacing * s.spacing * s.spacing);
  std::vector<std::uint8_t> inside(cells.size());
  for (std::size_t c = 0; c < inside.size(); ++c) inside[c] = volume[c] >= least;
  for (int axis = 0; axis < 3; ++axis) erode(inside, cells, axis);
  std::vector<std::uint8_t> hidden(s.particles);
  for (std::size_t p = 0; p < s.particles; ++p) hidden[p] = cell[p] < inside.size() ? inside[cell[p]] : 0;
  return hidden;
}

}  // namespace pf
