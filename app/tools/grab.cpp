#include "app/tools/grab.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "app/inside/overlay.hpp"
#include "app/widgets/units.hpp"

namespace pf::app {

namespace {

constexpr float slop = 3;  ///< pixels that a press may move and still be a click
constexpr double usual_radius = 3, least_radius = 0.75, most_radius = 40;  ///< [cells]

Vec3 position(const Snapshot& s, std::size_t particle) {
  Vec3 x = Vec3::Zero();
  const auto d = static_cast<std::size_t>(s.dimension);
  for (std::size_t a = 0; a < d; ++a) x[static_cast<int>(a)] = s.x[d * particle + a];
  return x;
}

/// 2D: whether material lies under the point, within one particle's reach.
bool over_material(const Snapshot& s, const Vec3& at) {
  const double reach = 0.75 * s.spacing;
  for (std::size_t p = 0; p < s.particles; ++p)
    if ((position(s, p) - at).squaredNorm() < reach * reach) return true;
  return false;
}

/// A coil from a to b, in pixels.
std::vector<Point2> coil(Point2 a, Point2 b, float width) {
  const float dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
  if (length < 4 * width) return {a, b};
  const float ux = dx / length, uy = dy / length;
  const int turns = 2 * std::clamp(static_cast<int>(length / (2.5F * width)), 3, 12);
  const float lead = std::min(2 * width, length / 6);
  std::vector<Point2> points{a, {a.x + ux * lead, a.y + uy * lead}};
  for (int k = 0; k < turns; ++k) {
    const float s = lead + (length - 2 * lead) * (static_cast<float>(k) + 0.5F) / static_cast<float>(turns);
    const float side = (k % 2 == 0 ? width : -width);
    points.push_back({a.x + ux * s - uy * side, a.y + uy * s + ux * side});
  }
  points.push_back({b.x - ux * lead, b.y - uy * lead});
  points.push_back(b);
  return points;
}

class GrabTool final : public Tool {
 public:
  bool press(const ViewMouse& mouse, AppContext& context) override {
    if (!context.snapshot || !mouse.particle || *mouse.particle >= context.snapshot->particles) return false;
    held_ = true;
    pulling_ = false;
    pressed_at_ = mouse.pixel;
    from_ = mouse.dimension == 2 ? mouse.origin : position(*context.snapshot, *mouse.particle);
    to_ = from_;
    if (!(cells_ > 0)) cells_ = usual_radius;
    return true;
  }

  void drag(const ViewMouse& mouse, AppContext& context) override {
    if (!held_) return;
    const float moved = std::hypot(mouse.pixel.x - pressed_at_.x, mouse.pixel.y - pressed_at_.y);
    if (!pulling_ && moved < slop) return;
    pulling_ = true;
    to_ = mouse.on_plane(from_);
    send(context);
  }

  void release(const ViewMouse&, AppContext& context) override { cancel(context); }

  void click(const ViewMouse& mouse, AppContext& context) override {
    if (mouse.ctrl) {
      select_node(mouse, context);
      return;
    }
    if (context.snapshot && mouse.particle && *mouse.particle < context.snapshot->id.size())
      context.selected_particle = context.snapshot->id[*mouse.particle];
    else
      context.selected_particle.reset();
  }

  bool wheel(float notches, const ViewMouse&, AppContext& context) override {
    if (!held_) return false;
    cells_ = std::clamp(cells_ * std::pow(1.15, static_cast<double>(notches)), least_radius, most_radius);
    if (pulling_) {
      // Another radius takes hold anew: of what is held now, not of what has come to where it was.
      if (context.snapshot && context.snapshot->grabbed) from_ = context.snapshot->grab_at;
      send(context);
    }
    return true;
  }

  void cancel(AppContext& context) override {
    if (pulling_) context.session.set_grab(std::nullopt);
    held_ = pulling_ = false;
  }

  void draw(Painter& painter, const ViewMap& map, const ViewMouse* mouse, const AppContext& context) override {
    if (!context.snapshot) return;
    if (held_)
      draw_held(painter, map, mouse, context);
    else if (mouse != nullptr && mouse->dimension == 2 && over_material(*context.snapshot, mouse->origin))
      draw_reach(painter, map, *context.snapshot, mouse->origin, 0.55F);
  }

 private:
  double radius(const Snapshot& s) const { return cells_ * s.spacing; }

  void send(AppContext& context) const {
    if (context.snapshot) context.session.set_grab(Grab{from_, to_, radius(*context.snapshot)});
  }

  void draw_reach(Painter& painter, const ViewMap& map, const Snapshot& s, const Vec3& at, float strength) const {
    const auto centre = map.to_pixel(at);
    if (!centre) return;
    const auto r = static_cast<float>(radius(s) / map.metres_per_pixel(at));
    // A dark line under a light one shows on every colour.
    painter.ring(*centre, r, {0, 0, 0, 0.45F * strength}, 0.22F * map.em());
    painter.ring(*centre, r, {1, 1, 1, 0.9F * strength}, 0.1F * map.em());
  }

  void draw_held(Painter& painter, const ViewMap& map, const ViewMouse* mouse, const AppContext& context) const {
    const Snapshot& s = *context.snapshot;
    const Vec3 at = s.grabbed && pulling_ ? s.grab_at : from_;
    draw_reach(painter, map, s, at, 1);
    if (!pulling_) return;
    const auto a = map.to_pixel(at), b = map.to_pixel(to_);
    if (!a || !b) return;
    const float em = map.em();
    const std::vector<Point2> spring = coil(*a, *b, 0.35F * em);
    painter.polyline(spring, {0, 0, 0, 0.5F}, 0.28F * em);
    painter.polyline(spring, {1, 1, 1, 0.95F}, 0.13F * em);
    painter.circle(*a, 0.24F * em, {0, 0, 0, 0.5F});
    painter.circle(*a, 0.17F * em, {1, 1, 1, 1});
    label(painter, mouse ? mouse->pixel : *b, quantity(s.report.grab_force, "N", 3), em);
  }

  static void label(Painter& painter, Point2 cursor, const std::string& text, float em) {
    const float pad = 0.35F * em, width = painter.text_width(text, em);
    const Point2 low{cursor.x + 1.2F * em, cursor.y - 1.7F * em};
    painter.rectangle(low, {low.x + width + 2 * pad, low.y + em + 2 * pad}, {0, 0, 0, 0.72F}, 0.25F * em);
    painter.text({low.x + pad, low.y + pad + 0.8F * em}, text, em, {1, 1, 1, 1});
  }

  bool held_ = false, pulling_ = false;
  Point2 pressed_at_;
  Vec3 from_ = Vec3::Zero(), to_ = Vec3::Zero();
  double cells_ = usual_radius;  ///< radius in cells: means the same in every scene; kept from grab to grab
};

}  // namespace

std::unique_ptr<Tool> make_grab_tool() {
  return std::make_unique<GrabTool>();
}

}  // namespace pf::app
