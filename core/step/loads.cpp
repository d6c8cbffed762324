#include "core/step/loads.hpp"

#include <cmath>

#include "core/math/vector_ops.hpp"
#include "core/scene/scene_io.hpp"
#include "core/scene/solid.hpp"
#include "core/transfers/transfer.hpp"

namespace pf {

template <int D>
Loads<D>::Loads(const Scene& scene) : gravity_(scene.gravity.head<D>()) {
  set_formulas(scene);
  for (std::size_t k = 0; k < scene.loads.size(); ++k) {
    const Load& load = scene.loads[k];
    const std::unique_ptr<Solid> region = make_solid(load.region, D, scene.constants);
    const std::size_t before = surface_.X.size();
    for (const Body& body : scene.bodies)
      if (body.name == load.body)
        surface_.add(scene, body, static_cast<std::uint16_t>(k), [&](const SurfacePoint& point) {
          return region->contains(point.position, 1e-9 * scene.grid.spacing);
        });
    if (surface_.X.size() == before)
      throw InputError(
          "", {{"/loads/" + std::to_string(k) + "/region", "no part of the surface of body \"" + load.body + "\"",
                "a region that holds a part of that body's surface at t = 0", 0}});
  }
}

template <int D>
void Loads<D>::set_formulas(const Scene& scene) {
  body_force_ = FormulaField<D>(scene.body_force, scene.constants, mask_all);
  traction_.clear();
  for (const Load& load : scene.loads) traction_.emplace_back(load.traction, scene.constants, mask_all);
}

template <int D>
void Loads<D>::force(const Plan<D>& plan, const Particles<D>& particles, const Vector& lumped_mass, double t,
                     Parallel& parallel, Vector& f) const {
  f.resize(lumped_mass.size() * D);
  for (Eigen::Index i = 0; i < lumped_mass.size(); ++i) f.segment<D>(i * D) = lumped_mass[i] * gravity_;
  if (!body_force_.zero()) {
    std::vector<Vec<D>> values(particles.size());
    for_pieces(parallel, static_cast<std::ptrdiff_t>(values.size()), [&](std::ptrdiff_t begin, std::ptrdiff_t count) {
      for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(begin + count); ++p)
        values[p] = particles.mass[p] * body_force_(particles.X[p], particles.x[p], t);
    });
    scatter_field<D>(plan, values, parallel, f);
  }
  if (surface_.size() > 0) {
    std::vector<Vec<D>> traction(surface_.size());
    for (std::size_t s = 0; s < surface_.size(); ++s)
      traction[s] = traction_[surface_.tag[s]](surface_.X[s], surface_.x[s], t);
    surface_.spread(plan, traction, f);
  }
}

template class Loads<2>;
template class Loads<3>;

}  // namespace pf
