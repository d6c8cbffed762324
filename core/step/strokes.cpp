// Particles cut away, or given another material, between two steps.
#include <algorithm>

#include "core/scene/scene_io.hpp"
#include "core/scene/solid.hpp"
#include "core/step/balance.hpp"
#include "core/step/edge_planes.hpp"
#include "core/step/simulation_of.hpp"

namespace pf {

namespace {

[[noreturn]] void refuse(const char* found, const char* allowed) {
  throw InputError("", {{"/events/-/strokes/-", found, allowed, 0}});
}

/// Which of the points the solid holds.
template <int D>
std::vector<char> within(const Solid& solid, const std::vector<Vec<D>>& x, double tolerance) {
  const Bounds bounds = solid.bounds();
  std::vector<char> meant(x.size(), 0);
  for (std::size_t p = 0; p < x.size(); ++p) {
    Vec3 at = Vec3::Zero();
    at.head<D>() = x[p];
    const bool near = ((at - bounds.min).array() >= -tolerance).template head<D>().all() &&
                      ((bounds.max - at).array() >= -tolerance).template head<D>().all();
    meant[p] = near && solid.contains(at, tolerance) ? 1 : 0;
  }
  return meant;
}

}  // namespace

/// The others stay as they are, in their order.
template <int D>
void SimulationOf<D>::take_away(const std::vector<char>& gone) {
  set_grab(std::nullopt);  // it may have held some of them
  particles_.each([&](auto& values) {
    if (values.empty()) return;
    std::size_t kept = 0;
    for (std::size_t p = 0; p < gone.size(); ++p)
      if (!gone[p]) values[kept++] = values[p];
    values.resize(kept);
  });
}

template <int D>
void SimulationOf<D>::repaint(const std::vector<char>& meant, std::uint16_t material) {
  for (std::size_t p = 0; p < meant.size(); ++p) {
    if (!meant[p]) continue;
    particles_.material[p] = material;
    particles_.mass[p] = scene_.materials[material].density * particles_.volume0[p];
  }
}

template <int D>
std::size_t SimulationOf<D>::stroke(const Stroke& stroke) {
  if (known_.known()) refuse("a stroke through a body whose motion is known", "scenes without \"exact\"");
  const bool cut = stroke.kind == "cut";
  const auto found = std::find_if(scene_.materials.begin(), scene_.materials.end(),
                                  [&](const Material& m) { return m.name == stroke.material; });
  if (!cut && found == scene_.materials.end()) refuse("an unknown material", "a key of \"materials\"");
  const auto material = static_cast<std::uint16_t>(found - scene_.materials.begin());
  const std::unique_ptr<Solid> solid = make_solid(stroke.shape, D, scene_.constants);
  const double tolerance = 1e-9 * scene_.grid.spacing;
  std::vector<char> meant = within(*solid, particles_.x, tolerance);
  for (std::size_t p = 0; !cut && p < meant.size(); ++p)
    if (particles_.material[p] == material) meant[p] = 0;
  const auto count = static_cast<std::size_t>(std::count(meant.begin(), meant.end(), 1));
  if (count == 0) return 0;
  if (cut && count == meant.size()) refuse("a cut that takes all particles away", "one that leaves some");
  const Balance before = accepted_.balance;
  const double mass_before = mass();
  if (cut) {
    take_away(meant);
    // What was pushed or pulled at there is gone, too.
    SurfacePoints<D>& loaded = loads_.surface();
    const std::vector<char> bare = within(*solid, loaded.x, tolerance);
    for (std::size_t s = 0; s < bare.size(); ++s)
      if (bare[s]) loaded.area[s] = 0;
    plan_.set_edges(edge_planes(scene_, particles_));
  } else {
    repaint(meant, material);
  }
  build_plan_or_throw();
  elastic_memory_.rest_plan = -1;
  stable_ = {};
  make_control();
  accepted_.balance = particle_balance<D>(particles_, laws_, plan_, transfer_->affine(), loads_.gravity(), parallel_);
  if (!find_integrator(scene_.integrator.type)->inertia) accepted_.balance.kinetic = 0;
  const Balance& after = accepted_.balance;
  stroked_energy_ += after.total() - before.total();
  stroked_angular_ += after.angular_momentum - before.angular_momentum;
  ++strokes_.count;
  (cut ? strokes_.cut : strokes_.painted) += count;
  strokes_.mass += mass_before - mass();
  strokes_.energy += before.total() - after.total();
  strokes_.momentum += before.momentum - after.momentum;
  accepted_.strokes = strokes_;
  return count;
}

template std::size_t SimulationOf<2>::stroke(const Stroke&);
template std::size_t SimulationOf<3>::stroke(const Stroke&);

}  // namespace pf
