#include "render/particle_layer_2d.hpp"

#include <array>
#include <cstddef>

namespace pf {

namespace {

struct Square {
  glm::vec2 x;
  glm::vec4 F;  // columns
  float side, value;
};
struct Point {
  glm::vec3 x;
  float side, value;
};
constexpr std::array square_layout{gl::Attribute{0, 2, offsetof(Square, x)}, gl::Attribute{1, 4, offsetof(Square, F)},
                                   gl::Attribute{2, 1, offsetof(Square, side)},
                                   gl::Attribute{3, 1, offsetof(Square, value)}};
constexpr std::array point_layout{gl::Attribute{0, 3, offsetof(Point, x)}, gl::Attribute{1, 1, offsetof(Point, side)},
                                  gl::Attribute{2, 1, offsetof(Point, value)}};

/// More particles than this are GL points on a software renderer.
constexpr std::size_t many = 100000;

float determinant(const glm::vec4& F) {
  return F.x * F.w - F.y * F.z;
}

}  // namespace

ParticleLayer2D::ParticleLayer2D()
    : square_data_(sizeof(Square), square_layout, true), point_data_(sizeof(Point), point_layout, false) {}

void ParticleLayer2D::upload(const Frame& frame) {
  const Snapshot& s = frame.snapshot;
  anchor_.drop_at(frame);
  std::vector<Square> squares;
  std::vector<Point> points;
  std::vector<Mark> marks;
  (cheap_ ? points.reserve(s.particles) : squares.reserve(s.particles));
  const bool has_F = s.F.size() >= 4 * s.particles;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const glm::vec3 x = relative(component_vector(s.x, p, 2), anchor_);
    const glm::vec4 F =
        has_F ? glm::vec4(s.F[4 * p], s.F[4 * p + 1], s.F[4 * p + 2], s.F[4 * p + 3]) : glm::vec4(1, 0, 0, 1);
    const float J = determinant(F), value = color_value(s, frame.options.field, p);
    const float side = p < s.volume0.size() ? std::sqrt(s.volume0[p]) : 0.5f * static_cast<float>(s.spacing);
    if (cheap_)
      points.push_back({x, side * std::sqrt(std::max(J, 0.f)), value});
    else
      squares.push_back({{x.x, x.y}, F, side, value});
    if (!(J > 0)) marks.push_back({x, rgba8(frame.theme().inverted), 5, static_cast<float>(MarkStyle::cross)});
    if (frame.options.selected && p < s.id.size() && s.id[p] == *frame.options.selected)
      marks.push_back({x, rgba8(frame.theme().selection), 9, static_cast<float>(MarkStyle::ring)});
  }
  square_data_.upload(squares);
  point_data_.upload(points);
  marks_.upload({}, marks);
}

void ParticleLayer2D::draw_squares(const Frame& frame) {
  squares_.use();
  squares_.set("u_view_projection", frame.view_projection);
  squares_.set("u_offset", anchor_.offset(frame));
  squares_.set("u_half_size", 0.5f * frame.size());
  squares_.set("u_pixels_per_metre", static_cast<float>(frame.pixels_per_metre));
  squares_.set("u_round", !frame.options.deformed);
  squares_.set("u_scale", frame.scale());
  squares_.set("u_range", glm::vec2(frame.range.min, frame.range.max));
  squares_.set("u_rim", frame.theme().outline);
  squares_.set("u_map", 0);
  // A thin line around bodies sets dark ones off from a dark background. It doubles the work.
  const bool affordable = !frame.software || frame.options.best_quality || frame.snapshot.particles < 20000;
  if (frame.options.deformed && affordable) {
    squares_.set("u_silhouette", rgba(frame.theme().silhouette));
    squares_.set("u_grow", 1.2f * frame.scale());
    square_data_.draw_quads();
  }
  squares_.set("u_silhouette", glm::vec4(0));
  squares_.set("u_grow", 0.f);
  square_data_.draw_quads();
}

void ParticleLayer2D::draw_points(const Frame& frame) {
  points_.use();
  points_.set("u_view_projection", frame.view_projection);
  points_.set("u_offset", anchor_.offset(frame));
  points_.set("u_pixels", static_cast<float>(frame.pixels_per_metre));
  points_.set("u_perspective", false);
  points_.set("u_smallest", 1.5f * frame.scale());
  points_.set("u_range", glm::vec2(frame.range.min, frame.range.max));
  points_.set("u_map", 0);
  glDisable(GL_BLEND);
  glEnable(GL_PROGRAM_POINT_SIZE);
  point_data_.draw_vertices(GL_POINTS);
  glDisable(GL_PROGRAM_POINT_SIZE);
  glEnable(GL_BLEND);
}

void ParticleLayer2D::draw(const Frame& frame, ColorTexture& colors, InkPrograms& ink) {
  const bool cheap = frame.software && !frame.options.best_quality && frame.snapshot.particles > many;
  const double selected = frame.options.selected ? *frame.options.selected : -1;
  const DataKey key = DataKey::of(frame, selected + (cheap ? 0.5 : 0));
  if (key != key_ || !anchor_.serves(frame)) {
    cheap_ = cheap;
    upload(frame);
    key_ = key;
  }
  colors.bind(field_info(frame.options.field).scale);
  cheap_ ? draw_points(frame) : draw_squares(frame);
  marks_.draw(ink, frame, anchor_, 1);
}

}  // namespace pf
