#include "core/step/known_motion.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/vector_ops.hpp"
#include "core/transfers/transfer.hpp"

namespace pf {

template <int D>
KnownMotion<D>::KnownMotion(const Scene& scene, const Conditions<D>& conditions) : manufactured_(scene.manufactured) {
  if (scene.exact_position.empty()) return;
  motion_.emplace(scene);
  if (!manufactured_) return;
  for (const Body& body : scene.bodies)
    for (std::size_t k = 0; k < scene.materials.size(); ++k)
      if (scene.materials[k].name == body.material)
        surface_.add(scene, body, static_cast<std::uint16_t>(k), [&](const SurfacePoint& point) {
          const Mat<D> free = conditions.free_at(Vec<D>(point.position.template head<D>()));
          if (!free.isZero(0)) free_.push_back(free);
          return !free.isZero(0);
        });
  for (std::size_t s = 0; s < surface_.size(); ++s) surface_.x[s] = motion_->position(surface_.X[s], 0);
}

template <int D>
void KnownMotion<D>::set_initial_state(Particles<D>& particles) const {
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const MotionPoint<D> at = motion_->at(particles.X[p], 0);
    particles.x[p] = at.position;
    particles.v[p] = at.velocity;
    particles.F[p] = at.F;
  }
}

template <int D>
void KnownMotion<D>::add_force(const Plan<D>& plan, const Particles<D>& particles, const Laws<D>& laws,
                               const Scene& scene, double t, Parallel& parallel, Vector& f) const {
  const Vec<D> gravity = scene.gravity.head<D>();
  const auto loads_of = [&](std::uint16_t material) {
    return ManufacturedLoads<D>(*motion_, *laws[material], scene.materials[material].density, gravity);
  };
  std::vector<Vec<D>> force(particles.size());
  const std::vector<MaterialRun>& runs = plan.runs();
  parallel(static_cast<int>(runs.size()), [&](int r) {
    const MaterialRun& run = runs[static_cast<std::size_t>(r)];
    const auto n = static_cast<std::size_t>(run.end - run.begin);
    loads_of(run.material).body_acceleration({particles.X.data() + run.begin, n}, t, {force.data() + run.begin, n});
    for (auto p = static_cast<std::size_t>(run.begin); p < static_cast<std::size_t>(run.end); ++p)
      force[p] *= particles.mass[p];
  });
  scatter_field<D>(plan, force, parallel, f);
  std::vector<Vec<D>> traction(surface_.size());
  for (std::size_t s = 0; s < surface_.size(); ++s) {
    loads_of(surface_.tag[s]).traction({&surface_.X[s], 1}, {&surface_.normal[s], 1}, t, {&traction[s], 1});
    traction[s] = free_[s] * traction[s];
  }
  surface_.spread(plan, traction, f);
}

template <int D>
ErrorNorms KnownMotion<D>::errors(const Particles<D>& particles, double t, Parallel& parallel) const {
  struct Sums {
    double mass = 0, x = 0, v = 0, F = 0, max = 0;
  };
  const auto n = static_cast<std::ptrdiff_t>(particles.size());
  constexpr std::ptrdiff_t piece = 512;
  std::vector<Sums> sums(static_cast<std::size_t>((n + piece - 1) / piece));
  parallel(static_cast<int>(sums.size()), [&](int k) {
    Sums& s = sums[static_cast<std::size_t>(k)];
    for (std::ptrdiff_t i = k * piece; i < std::min(n, (k + 1) * piece); ++i) {
      const auto p = static_cast<std::size_t>(i);
      const MotionPoint<D> at = motion_->at(particles.X[p], t);
      const double m = particles.mass[p], x2 = (particles.x[p] - at.position).squaredNorm();
      s.mass += m;
      s.x += m * x2;
      s.v += m * (particles.v[p] - at.velocity).squaredNorm();
      s.F += m * (particles.F[p] - at.F).squaredNorm();
      s.max = std::max(s.max, std::sqrt(x2));
    }
  });
  Sums all;
  for (const Sums& s : sums) {
    all.mass += s.mass;
    all.x += s.x;
    all.v += s.v;
    all.F += s.F;
    all.max = std::max(all.max, s.max);
  }
  return {true, std::sqrt(all.x / all.mass), all.max, std::sqrt(all.v / all.mass), std::sqrt(all.F / all.mass)};
}

template <int D>
void KnownMotion<D>::displacement_errors(const Particles<D>& particles, double t, std::vector<double>& error) const {
  for (std::size_t p = 0; p < particles.size(); ++p)
    error[p] = (particles.x[p] - motion_->position(particles.X[p], t)).norm();
}

template class KnownMotion<2>;
template class KnownMotion<3>;

}  // namespace pf
