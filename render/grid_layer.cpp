#include "render/grid_layer.hpp"

#include <array>
#include <unordered_map>

#include "core/charts/colormap.hpp"

namespace pf {

namespace {

struct Cell {
  glm::vec2 min;
};
constexpr std::array cell_layout{gl::Attribute{0, 2, 0}};

/// One number for three lattice coordinates (21 bits each, which is 2 million cells a direction).
std::uint64_t lattice_key(std::int64_t i, std::int64_t j, std::int64_t k) {
  constexpr std::uint64_t mask = (1u << 21) - 1;
  return (static_cast<std::uint64_t>(i) & mask) | (static_cast<std::uint64_t>(j) & mask) << 21 |
         (static_cast<std::uint64_t>(k) & mask) << 42;
}

std::uint8_t state(const Snapshot& s, std::size_t i) {
  return i < s.node_state.size() ? s.node_state[i] : 0;
}

Vec3 node_position(const Snapshot& s, std::size_t i) {
  return s.spacing * component_vector(s.node_index, i, s.dimension);
}

/// Every so manieth node in each direction, where the lattice is too fine to show all arrows.
int arrow_stride(double cell_pixels, float scale) {
  return std::max(1, static_cast<int>(std::ceil(13 * scale / std::max(cell_pixels, 1e-3))));
}

double percentile95(std::vector<double>& values) {
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The nodes have the field's colours.
bool colored(const Frame& frame) {
  return field_info(frame.options.field).on_nodes &&
         frame.snapshot.field[static_cast<std::size_t>(frame.options.field)].size() == frame.snapshot.nodes;
}

bool has_nodes(const Snapshot& s) {
  return s.nodes > 0 && s.node_index.size() >= s.nodes * static_cast<std::size_t>(s.dimension);
}

}  // namespace

GridLayer::GridLayer() : cells_(sizeof(Cell), cell_layout, true) {}

void GridLayer::invalidate() {
  cell_key_ = node_key_ = arrow_key_ = bent_key_ = {};
  reference_speed_ = 0;
}

void GridLayer::upload_cells(const Frame& frame) {
  const Snapshot& s = frame.snapshot;
  cell_anchor_.drop_at(frame);
  std::vector<Cell> cells;
  std::unordered_map<std::uint64_t, bool> known;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const double i = std::floor(s.x[2 * p] / s.spacing), j = std::floor(s.x[2 * p + 1] / s.spacing);
    if (!std::isfinite(i) || !std::isfinite(j)) continue;
    if (!known.emplace(lattice_key(static_cast<std::int64_t>(i), static_cast<std::int64_t>(j), 0), true).second)
      continue;
    const glm::vec3 at = relative({i * s.spacing, j * s.spacing, 0}, cell_anchor_);
    cells.push_back({{at.x, at.y}});
  }
  cells_.upload(cells);
}

void GridLayer::draw_cells(const Frame& frame) {
  const DataKey key = DataKey::of(frame);
  if (key != cell_key_ || !cell_anchor_.serves(frame)) {
    upload_cells(frame);
    cell_key_ = key;
  }
  cell_program_.use();
  cell_program_.set("u_view_projection", frame.view_projection);
  cell_program_.set("u_offset", cell_anchor_.offset(frame));
  cell_program_.set("u_dx", static_cast<float>(frame.snapshot.spacing));
  cell_program_.set("u_color", rgba(frame.theme().cell));
  cells_.draw_quads();
}

void GridLayer::upload_nodes(const Frame& frame) {
  const Snapshot& s = frame.snapshot;
  const RenderTheme& theme = frame.theme();
  node_anchor_.drop_at(frame);
  const double cell = s.spacing * frame.pixels_per_metre / frame.scale();  // layout pixels
  const float radius = static_cast<float>(std::clamp(0.07 * cell, 0.8, 3.0));
  const float fade = static_cast<float>(std::clamp((cell - 4) / 6, 0.0, 1.0));
  std::vector<Mark> marks;
  if (colored(frame)) {
    const auto& values = s.field[static_cast<std::size_t>(frame.options.field)];
    const bool diverging = frame.color_scale() == ColorScale::symmetric;
    const float dot = static_cast<float>(std::clamp(0.24 * cell, 2.0, 7.0));
    for (std::size_t i = 0; i < s.nodes; ++i) {
      const double u = map_position(values[i], frame.range, frame.color_scale());
      const Color color = sample(diverging ? ColormapKind::diverging : ColormapKind::sequential, u);
      const glm::vec3 at = relative(node_position(s, i), node_anchor_);
      marks.push_back({at, rgba8(frame.theme().arrow_rim), dot + 1, static_cast<float>(MarkStyle::dot)});
      marks.push_back({at, rgba8(color), dot, static_cast<float>(MarkStyle::dot)});
    }
    return nodes_.upload({}, marks);
  }
  for (std::size_t i = 0; i < s.nodes; ++i) {
    const glm::vec3 at = relative(node_position(s, i), node_anchor_);
    const std::uint8_t bits = state(s, i);
    Color color = theme.node;
    float size = radius;
    MarkStyle style = MarkStyle::dot;
    if (bits & 1) {
      color = theme.node_fixed, size = 1.5f * radius, style = MarkStyle::square;
    } else if (bits & 2) {
      color = theme.node_contact, size = 1.6f * radius;
    } else if (bits & 4) {
      color = theme.node_contact, size = 1.4f * radius, style = MarkStyle::ring;
      color.a *= 0.7f;
    }
    if (!(bits & 7)) color.a *= fade;
    if (color.a > 0) marks.push_back({at, rgba8(color), size, static_cast<float>(style)});
  }
  nodes_.upload({}, marks);
}

void GridLayer::upload_arrows(const Frame& frame) {
  const Snapshot& s = frame.snapshot;
  arrow_anchor_.drop_at(frame);
  std::vector<double> speeds;
  speeds.reserve(s.nodes);
  for (std::size_t i = 0; i < s.nodes; ++i) speeds.push_back(component_vector(s.node_velocity, i, s.dimension).norm());
  std::vector<double> sorted = speeds;
  reference_speed_ = std::max(percentile95(sorted), 0.97 * reference_speed_);
  const double cell = s.spacing * frame.pixels_per_metre;
  const int stride = arrow_stride(cell, frame.scale());
  const double longest = std::clamp(1.4 * stride * cell, 16.0 * frame.scale(), 56.0 * frame.scale());
  arrow_scale_ = reference_speed_ > 0 ? longest / reference_speed_ : 0;
  const double metres = arrow_scale_ / frame.pixels_per_metre;
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < s.nodes; ++i) {
    bool shown = speeds[i] * arrow_scale_ > 1.5;
    for (int a = 0; a < s.dimension; ++a)
      shown = shown && s.node_index[i * static_cast<std::size_t>(s.dimension) + a] % stride == 0;
    if (!shown) continue;
    const Vec3 from = node_position(s, i);
    // An outlier shall not cross the picture: three times the reference at most.
    const double shorter = std::min(1.0, 3 * reference_speed_ / speeds[i]);
    const Vec3 to = from + metres * shorter * component_vector(s.node_velocity, i, s.dimension);
    segments.push_back({relative(from, arrow_anchor_), relative(to, arrow_anchor_), rgba8(frame.theme().arrow)});
  }
  arrows_.upload(segments, {});
}

void GridLayer::upload_bent(const Frame& frame) {
  const Snapshot& s = frame.snapshot;
  bent_anchor_.drop_at(frame);
  std::unordered_map<std::uint64_t, std::size_t> at;
  at.reserve(s.nodes);
  const auto d = static_cast<std::size_t>(s.dimension);
  const auto index = [&](std::size_t i, std::size_t a) { return a < d ? s.node_index[i * d + a] : 0; };
  // A node with next to no mass goes wherever its few grams are thrown: a line to it would tell of nothing.
  double heaviest = 0;
  for (const double m : s.node_mass) heaviest = std::max(heaviest, m);
  const auto light = [&](std::size_t i) { return i < s.node_mass.size() && s.node_mass[i] < 0.01 * heaviest; };
  for (std::size_t i = 0; i < s.nodes; ++i)
    if (!light(i)) at.emplace(lattice_key(index(i, 0), index(i, 1), index(i, 2)), i);
  const auto image = [&](std::size_t i) {
    const Vec3 u = component_vector(s.node_displacement, i, s.dimension);
    return relative(node_position(s, i) + frame.options.bent_magnification * u, bent_anchor_);
  };
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < s.nodes; ++i) {
    for (std::size_t a = 0; a < d && !light(i); ++a) {
      const auto next = at.find(lattice_key(index(i, 0) + (a == 0), index(i, 1) + (a == 1), index(i, 2) + (a == 2)));
      if (next != at.end()) segments.push_back({image(i), image(next->second), rgba8(frame.theme().bent_grid)});
    }
  }
  bent_.upload(segments, {});
}

void GridLayer::draw(const Frame& frame, InkPrograms& ink) {
  const Snapshot& s = frame.snapshot;
  arrow_scale_ = frame.options.velocities ? arrow_scale_ : 0;
  if (!has_nodes(s)) return;
  const std::size_t components = s.nodes * static_cast<std::size_t>(s.dimension);
  if (frame.options.bent_grid && s.node_displacement.size() >= components) {
    const DataKey key = DataKey::of(frame, frame.options.bent_magnification);
    if (key != bent_key_ || !bent_anchor_.serves(frame)) upload_bent(frame);
    bent_key_ = key;
    // Where cells are small, thick lines would hide the material.
    const double cell = s.spacing * frame.pixels_per_metre / frame.scale();
    bent_.draw(ink, frame, bent_anchor_, static_cast<float>(std::clamp(0.07 * cell, 0.5, 1.2)), 0,
               frame.theme().arrow_rim);
  }
  if (frame.options.grid || colored(frame)) {
    const DataKey key = DataKey::of(frame, frame.pixels_per_metre);
    const ValueRange range = colored(frame) ? frame.range : ValueRange{};
    if (key != node_key_ || range != node_range_ || !node_anchor_.serves(frame)) upload_nodes(frame);
    node_key_ = key;
    node_range_ = range;
    nodes_.draw(ink, frame, node_anchor_, 1);
  }
  if (frame.options.velocities && s.node_velocity.size() >= components) {
    const DataKey key = DataKey::of(frame, frame.pixels_per_metre);
    if (key != arrow_key_ || !arrow_anchor_.serves(frame)) upload_arrows(frame);
    arrow_key_ = key;
    arrows_.draw(ink, frame, arrow_anchor_, 1.4f, 7, frame.theme().arrow_rim);
  }
}

}  // namespace pf
