#include "core/step/loads.hpp"

#include <cmath>

#include "core/scene/scene_io.hpp"
#include "core/scene/solid.hpp"
#include "core/math/vector_ops.hpp"
#include "core/transfers/transfer.hpp"

namespace pf {

template <int D>
Loads<D>::Loads(const Scene& scene)
    : gravity_(scene.gravity.head<D>()), body_force_(scene.body_force, scene.constants, mask_all) {
  const double h = scene.grid.spacing / (D == 2 ? 8 : 4);
  for (std::size_t k = 0; k < scene.loads.size(); ++k) {
    const Load& load = scene.loads[k];
    traction_.emplace_back(load.traction, scene.constants, mask_all);
    const std::unique_ptr<Solid> region = make_solid(load.region, D, scene.constants);
    const std::size_t before = surface_.X.size();
    for (const Body& body : scene.bodies) {
      if (body.name != load.body) continue;
      for (const SurfacePoint& point : make_solid(body.shape, D, scene.constants)->surface(h)) {
        if (!region->contains(point.position, 1e-9 * scene.grid.spacing)) continue;
        surface_.X.push_back(point.position.head<D>());
        surface_.x.push_back(point.position.head<D>());
        surface_.normal.push_back(point.normal.head<D>());
        surface_.area.push_back(point.area);
        surface_.load.push_back(static_cast<std::uint16_t>(k));
      }
    }
    if (surface_.X.size() == before)
      throw InputError("", {{"/loads/" + std::to_string(k) + "/region", "no part of the surface of body \"" + load.body + "\"",
                             "a region that holds a part of that body's surface at t = 0", 0}});
  }
}

template <int D>
template <class Function>
void Loads<D>::around(const Plan<D>& plan, const Vec<D>& x, Function&& f) {
  const int K = plan.nodes_per_axis();
  double N[D][max_nodes_per_axis], dN[max_nodes_per_axis];
  long long base[D];
  for (int a = 0; a < D; ++a) plan.basis().weights(x[a] / plan.spacing(), base[a], N[a], dN);
  const int count = D == 2 ? K * K : K * K * K;
  int nodes[max_nodes_per_axis * max_nodes_per_axis * max_nodes_per_axis];
  double weights[max_nodes_per_axis * max_nodes_per_axis * max_nodes_per_axis];
  double sum = 0;
  for (int n = 0; n < count; ++n) {
    const int r[3] = {n % K, n / K % K, n / (K * K)};
    std::array<long long, D> index;
    weights[n] = 1;
    for (int a = 0; a < D; ++a) {
      index[static_cast<std::size_t>(a)] = base[a] + r[a];
      weights[n] *= N[a][r[a]];
    }
    nodes[n] = plan.find_node(index);
    if (nodes[n] >= 0) sum += weights[n];
  }
  if (!(sum > 0)) return;
  for (int n = 0; n < count; ++n)
    if (nodes[n] >= 0) f(nodes[n], weights[n] / sum);
}

template <int D>
Vector Loads<D>::force(const Plan<D>& plan, const Particles<D>& particles, const Vector& lumped_mass, double t,
                       Parallel& parallel) const {
  Vector f(lumped_mass.size() * D);
  for (Eigen::Index i = 0; i < lumped_mass.size(); ++i) f.segment<D>(i * D) = lumped_mass[i] * gravity_;
  if (!body_force_.zero()) {
    std::vector<Vec<D>> values(particles.size());
    for_pieces(parallel, static_cast<std::ptrdiff_t>(values.size()), [&](std::ptrdiff_t begin, std::ptrdiff_t count) {
      for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(begin + count); ++p)
        values[p] = particles.mass[p] * body_force_(particles.X[p], particles.x[p], t);
    });
    scatter_field<D>(plan, values, parallel, f);
  }
  for (std::size_t s = 0; s < surface_.x.size(); ++s) {
    const FormulaField<D>& traction = traction_[surface_.load[s]];
    if (traction.zero()) continue;
    const Vec<D> force = surface_.area[s] * traction(surface_.X[s], surface_.x[s], t);
    around(plan, surface_.x[s], [&](int node, double weight) { f.segment<D>(node * D) += weight * force; });
  }
  return f;
}

template <int D>
void Loads<D>::move(const Plan<D>& plan, const Vector& u) {
  for (Vec<D>& x : surface_.x) {
    Vec<D> moved = Vec<D>::Zero();
    around(plan, x, [&](int node, double weight) { moved += weight * u.segment<D>(node * D); });
    x += moved;
  }
}

template class Loads<2>;
template class Loads<3>;

}  // namespace pf
