#include "render/particle_layer_3d.hpp"

#include <array>
#include <cstddef>

#include "render/hidden.hpp"
#include "render/particle_shape.hpp"

namespace pf {

namespace {

struct Ball {
  glm::vec3 x, F0, F1, F2;
  float radius, value;
};
struct Point {
  glm::vec3 x;
  float side, value;
};
constexpr std::array ball_layout{gl::Attribute{0, 3, offsetof(Ball, x)}, gl::Attribute{1, 3, offsetof(Ball, F0)},
                                 gl::Attribute{2, 3, offsetof(Ball, F1)}, gl::Attribute{3, 3, offsetof(Ball, F2)},
                                 gl::Attribute{4, 2, offsetof(Ball, radius)}};
constexpr std::array point_layout{gl::Attribute{0, 3, offsetof(Point, x)}, gl::Attribute{1, 1, offsetof(Point, side)},
                                  gl::Attribute{2, 1, offsetof(Point, value)}};

/// On a software renderer: more than `some` are discs while things move, more than `many` always.
constexpr std::size_t some = 1000, many = 100000;
/// Radius of the ball of volume 1.
constexpr float unit_ball = 0.6203505f;

}  // namespace

void Shadow::set(Program& program) const {
  if (!on) return;
  program.set("u_to_shadow", to_map);
  program.set("u_softness", softness);
  program.set("u_shadow_map", 2);
}

ParticleLayer3D::ParticleLayer3D()
    : ball_data_(sizeof(Ball), ball_layout, true), point_data_(sizeof(Point), point_layout, false) {}

void ParticleLayer3D::upload(const Frame& frame) {
  const Snapshot& s = frame.snapshot;
  anchor_.drop_at(frame);
  bounds_ = particle_bounds(s);
  std::vector<Ball> balls;
  std::vector<Point> points;
  std::vector<Mark> marks;
  (cheap_ ? points.reserve(s.particles) : balls.reserve(s.particles));
  const bool has_F = s.F.size() >= 9 * s.particles;
  // A graphics card draws what is hidden faster than we tell that it is.
  const bool all = !frame.software || frame.options.best_quality;
  const std::vector<std::uint8_t> hidden = all ? std::vector<std::uint8_t>() : hidden_particles(s);
  for (std::size_t p = 0; p < s.particles; ++p) {
    const glm::vec3 x = relative(component_vector(s.x, p, 3), anchor_);
    const float* f = s.F.data() + 9 * p;
    const glm::mat3 F = has_F ? glm::mat3(f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7], f[8]) : glm::mat3(1);
    const float side = side_of(s, p);
    const float value = shown_value(frame, p);
    const bool drawn = hidden.empty() || hidden[p] == 0;
    if (drawn && cheap_)
      points.push_back({x, 2 * unit_ball * side * std::cbrt(std::clamp(glm::determinant(F), 0.1f, 4.f)), value});
    if (drawn && !cheap_) {
      const glm::mat3 axes = mapped_by(s, p, F);
      balls.push_back({x, axes[0], axes[1], axes[2], unit_ball * side, value});
    }
    if (!(glm::determinant(F) > 0))
      marks.push_back({x, rgba8(frame.theme().inverted), 5, static_cast<float>(MarkStyle::cross)});
    if (frame.options.selected && p < s.id.size() && s.id[p] == *frame.options.selected)
      marks.push_back({x, rgba8(frame.theme().selection), 9, static_cast<float>(MarkStyle::ring)});
  }
  ball_data_.upload(balls);
  point_data_.upload(points);
  marks_.upload({}, marks);
}

void ParticleLayer3D::prepare(const Frame& frame) {
  const bool cheap = frame.software && !frame.options.best_quality &&
                     frame.snapshot.particles > (frame.options.in_motion ? some : many);
  const double selected = frame.options.selected ? *frame.options.selected : -1;
  const DataKey key = DataKey::of(frame, selected + (cheap ? 0.5 : 0));
  if (key == key_ && anchor_.serves(frame)) return;
  cheap_ = cheap;
  upload(frame);
  key_ = key;
}

Program& ParticleLayer3D::balls(const Frame& frame, const glm::mat4& view, const glm::mat4& projection, bool shadows) {
  Program& balls = balls_.form(shadows);
  balls.use();
  balls.set("u_view", view);
  balls.set("u_projection", projection);
  balls.set("u_offset", anchor_.offset(frame));
  balls.set("u_round", !frame.options.deformed);
  balls.set("u_map", 0);
  return balls;
}

void ParticleLayer3D::draw(const Frame& frame, const glm::mat4& view, const glm::mat4& projection, const Shadow& shadow,
                           ColorTexture& colors) {
  const glm::vec2 range = frame.shown_range();
  colors.bind(map_of(frame.color_scale()));
  if (cheap_) {
    points_.use();
    points_.set("u_view_projection", frame.view_projection);
    points_.set("u_offset", anchor_.offset(frame));
    points_.set("u_pixels", 0.5f * frame.size().y * projection[1][1]);
    const glm::mat3 to_eye(view);
    points_.set("u_light", to_eye * towards_light);
    points_.set("u_up", to_eye * glm::vec3(0, 1, 0));
    points_.set("u_smallest", 1.5f);
    points_.set("u_range", range);
    points_.set("u_map", 0);
    glEnable(GL_PROGRAM_POINT_SIZE);
    point_data_.draw_vertices(GL_POINTS);
    glDisable(GL_PROGRAM_POINT_SIZE);
    return;
  }
  Program& program = balls(frame, view, projection, shadow.on);
  program.set("u_orthographic", false);
  program.set("u_range", range);
  shadow.set(program);
  ball_data_.draw_quads();
}

void ParticleLayer3D::draw_shadow(const Frame& frame, const glm::mat4& view, const glm::mat4& projection) {
  balls(frame, view, projection, false).set("u_orthographic", true);
  ball_data_.draw_quads();
}

}  // namespace pf
