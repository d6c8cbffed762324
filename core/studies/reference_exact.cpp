// The exact motion as a reference: stress and energy from the laws at the exact F.
#include <Eigen/Geometry>

#include "core/materials/law.hpp"
#include "core/scene/exact_motion.hpp"
#include "core/studies/reference.hpp"

namespace pf {

namespace {

template <int D>
Vec3 in_space(const Vec<D>& x) {
  Vec3 y = Vec3::Zero();
  y.template head<D>() = x;
  return y;
}

template <int D>
class ExactReference final : public Reference {
 public:
  explicit ExactReference(const Scene& scene) : motion_(scene), gravity_(scene.gravity) {
    for (const Material& material : scene.materials) {
      std::vector<double> parameters;
      for (const auto& [name, value] : material.parameters) parameters.push_back(value);
      laws_.push_back(make_law<D>(material.model, parameters));
    }
  }

  ExpectedState at(int /*k*/, double time, std::span<const ParticleState> particles) const override {
    ExpectedState state;
    state.particles.resize(particles.size());
    Balance balance;
    for (std::size_t p = 0; p < particles.size(); ++p) {
      const ParticleState& particle = particles[p];
      const MotionPoint<D> point = motion_.at(Vec<D>(particle.X.template head<D>()), time);
      const Law<D>& law = *laws_[particle.material];
      Expected& expected = state.particles[p];
      expected.x = in_space<D>(point.position);
      expected.v = in_space<D>(point.velocity);
      expected.F.template topLeftCorner<D, D>() = point.F;
      expected.sigma = law.cauchy(point.F);
      double psi = 0;
      law.energy({&point.F, 1}, {&psi, 1});
      balance.elastic += particle.volume0 * psi;
      balance.kinetic += 0.5 * particle.mass * expected.v.squaredNorm();
      balance.potential -= particle.mass * gravity_.dot(expected.x);
      balance.momentum += particle.mass * expected.v;
      balance.angular_momentum += particle.mass * expected.x.cross(expected.v);
    }
    state.balance = balance;
    return state;
  }

  std::optional<Balance> initial(std::span<const ParticleState> particles) const override {
    return at(0, 0, particles).balance;
  }

 private:
  ExactMotion<D> motion_;
  Vec3 gravity_;
  std::vector<std::unique_ptr<Law<D>>> laws_;
};

}  // namespace

std::unique_ptr<Reference> make_exact_reference(const Scene& scene) {
  if (scene.dimension == 2) return std::make_unique<ExactReference<2>>(scene);
  return std::make_unique<ExactReference<3>>(scene);
}

}  // namespace pf
