#include "render/particle_layer_2d.hpp"

#include <array>
#include <cstddef>

#include "render/particle_shape.hpp"

namespace pf {

namespace {

struct Square {
  glm::vec2 x;
  glm::mat2 F;
  float side, value;
};
constexpr std::array square_layout{gl::Attribute{0, 2, offsetof(Square, x)}, gl::Attribute{1, 4, offsetof(Square, F)},
                                   gl::Attribute{2, 1, offsetof(Square, side)},
                                   gl::Attribute{3, 1, offsetof(Square, value)}};

/// On a software renderer: more particles than this are splats where each is only a few pixels wide, and more than
/// `very_many` are wherever.
constexpr std::size_t many = 20000, very_many = 200000;
constexpr double few_pixels = 6;

bool as_splats(const Frame& frame) {
  const Snapshot& s = frame.snapshot;
  if (!frame.software || frame.options.best_quality || s.particles <= many) return false;
  const double side = s.volume0.empty() ? 0.5 * s.spacing : std::sqrt(static_cast<double>(s.volume0[0]));
  return s.particles > very_many || side * frame.pixels_per_metre < few_pixels * static_cast<double>(frame.scale());
}

}  // namespace

ParticleLayer2D::ParticleLayer2D() : square_data_(sizeof(Square), square_layout, true) {}

void ParticleLayer2D::upload(const Frame& frame) {
  const Snapshot& s = frame.snapshot;
  anchor_.drop_at(frame);
  std::vector<Square> squares;
  std::vector<Mark> marks;
  if (!cheap_) squares.reserve(s.particles);
  const bool has_F = s.F.size() >= 4 * s.particles;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const glm::vec3 x = relative(component_vector(s.x, p, 2), anchor_);
    const glm::mat2 F = has_F ? glm::mat2(s.F[4 * p], s.F[4 * p + 1], s.F[4 * p + 2], s.F[4 * p + 3]) : glm::mat2(1);
    const float J = glm::determinant(F), value = shown_value(frame, p);
    if (!cheap_) squares.push_back({{x.x, x.y}, mapped_by(s, p, F), side_of(s, p), value});
    if (!(J > 0)) marks.push_back({x, rgba8(frame.theme().inverted), 5, static_cast<float>(MarkStyle::cross)});
    if (frame.options.selected && p < s.id.size() && s.id[p] == *frame.options.selected)
      marks.push_back({x, rgba8(frame.theme().selection), 9, static_cast<float>(MarkStyle::ring)});
  }
  square_data_.upload(squares);
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
  squares_.set("u_range", frame.shown_range());
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

void ParticleLayer2D::draw(const Frame& frame, ColorTexture& colors, InkPrograms& ink) {
  const bool cheap = as_splats(frame);
  const double selected = frame.options.selected ? *frame.options.selected : -1;
  const DataKey key = DataKey::of(frame, selected + (cheap ? 0.5 : 0));
  if (key != key_ || !anchor_.serves(frame)) {
    cheap_ = cheap;
    upload(frame);
    key_ = key;
  }
  if (cheap_) {
    splats_.draw(frame);
  } else {
    colors.bind(map_of(frame.color_scale()));
    draw_squares(frame);
  }
  marks_.draw(ink, frame, anchor_, 1);
}

}  // namespace pf
