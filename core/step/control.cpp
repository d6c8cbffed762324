// What step control is told of this simulation, and what it decides.
#include <algorithm>

#include "core/energies/explicit_limit.hpp"
#include "core/energies/stable_step.hpp"
#include "core/step/simulation_of.hpp"
#include "core/work_weights.hpp"

namespace pf {

/// The longest side of the largest body [m].
template <int D>
double SimulationOf<D>::size_of(const Particles<D>& particles, double spacing) {
  std::vector<Vec<D>> low, high;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const std::size_t body = particles.body[p];
    if (body >= low.size()) {
      low.resize(body + 1, Vec<D>::Constant(1e300));
      high.resize(body + 1, Vec<D>::Constant(-1e300));
    }
    low[body] = low[body].cwiseMin(particles.X[p]);
    high[body] = high[body].cwiseMax(particles.X[p]);
  }
  double size = spacing;
  for (std::size_t k = 0; k < low.size(); ++k) size = std::max(size, (high[k] - low[k]).maxCoeff());
  return size;
}

template <int D>
double SimulationOf<D>::weigh(const Work& work) const {
  return weighted_work(work, D, find_basis(scene_.grid.basis)->nodes_per_axis);
}

template <int D>
std::unique_ptr<StepControl> SimulationOf<D>::new_control() const {
  ControlSetup setup;
  setup.step = setup.largest = scene_.time.step;
  setup.tolerance = scene_.time.tolerance.value_or(default_tolerance);
  setup.spacing = scene_.grid.spacing;
  setup.size = size_;
  setup.dimension = D;
  for (std::size_t k = 0; k < laws_.size(); ++k)
    setup.wave_speed = std::max(setup.wave_speed, laws_[k]->wave_speed(scene_.materials[k].density));
  setup.implicit = find_integrator(scene_.integrator.type)->implicit;
  // With the consistent mass an explicit step solves a system, and its limit is another one.
  setup.may_be_explicit = scene_.integrator.mass == "lumped";
  const auto n = static_cast<std::uint64_t>(particles_.size());
  setup.explicit_work = weigh({.p2g = n, .g2p = n, .gradient = n});
  setup.limit_work = weigh({.tangent = n});
  setup.implicit_work = weigh({.p2g = n, .g2p = n, .energy = 2 * n, .gradient = n});
  setup.newton_work = weigh({.gradient = n, .tangent = n, .diagonal = n});
  setup.linear_work = weigh({.hessian_product = n});
  return make_step_control(scene_.time.control, setup);
}

template <int D>
void SimulationOf<D>::make_control() {
  size_ = size_of(particles_, scene_.grid.spacing);
  explicit_.reset();
  if (scene_.time.control == "adaptive") {
    if (!find_integrator(scene_.integrator.type)->implicit) integrator_ = make_integrator<D>("backward_euler");
    explicit_ = make_integrator<D>("symplectic_euler");
  }
  control_ = new_control();
}

template <int D>
Integrator<D>& SimulationOf<D>::integrator_of(const StepChoice& choice) {
  return explicit_ && !choice.implicit ? *explicit_ : *integrator_;
}

template <int D>
bool SimulationOf<D>::has_inertia(const StepChoice& choice) const {
  return !choice.implicit || find_integrator(scene_.integrator.type)->inertia;
}

template <int D>
StepChoice SimulationOf<D>::first_choice() {
  control_->keep();
  control_->allow_explicit(!grab_);
  if (control_->wants_limit()) control_->tell_limit(explicit_limit(plan_, particles_, laws_, parallel_, work_));
  return control_->next(time_, end_);
}

template <int D>
void SimulationOf<D>::tell_control(StepOutcome outcome, StepReport& report) {
  outcome.speed = report.cfl * scene_.grid.spacing / report.dt;
  outcome.retries = report.retries;
  outcome.time = time_;
  control_->accepted(outcome);
  if (control_->wants_positions()) {
    std::vector<double> x(particles_.size() * D);
    const std::vector<std::uint32_t> rank = ranks();
    for (std::size_t p = 0; p < particles_.size(); ++p)
      for (int a = 0; a < D; ++a)
        x[rank[particles_.id[p]] * D + static_cast<std::size_t>(a)] = particles_.x[p][a] / size_;
    control_->tell_positions(time_, x);
  }
  control_->report(report.control);
  report.control.implicit = outcome.choice.implicit;
  report.control.limited_by = outcome.choice.limited_by;
}

template <int D>
double SimulationOf<D>::stable_step() const {
  GridState<D> grid;
  particles_to_grid(plan_, particles_, false, parallel_, grid);
  Work uncounted;
  ElasticEnergy<D> elastic(plan_, particles_, laws_, parallel_, uncounted);
  BetweenSteps between;
  if (scene_.transfer.velocity_mass == "lumped") {
    between.carry = [&](const Vector& v, Vector& momentum) {
      transfer_->carry(plan_, particles_, v, parallel_, momentum);
    };
    between.stiffening = [&](double s) { return transfer_->stiffening(s); };
  }
  return pf::stable_step(elastic, grid.mass, conditions_.at(plan_, time_, 0), between);
}

#define PF_INSTANTIATE(D)                                                     \
  template double SimulationOf<D>::size_of(const Particles<D>&, double);      \
  template double SimulationOf<D>::weigh(const Work&) const;                  \
  template std::unique_ptr<StepControl> SimulationOf<D>::new_control() const; \
  template void SimulationOf<D>::make_control();                              \
  template Integrator<D>& SimulationOf<D>::integrator_of(const StepChoice&);  \
  template bool SimulationOf<D>::has_inertia(const StepChoice&) const;        \
  template StepChoice SimulationOf<D>::first_choice();                        \
  template void SimulationOf<D>::tell_control(StepOutcome, StepReport&);      \
  template double SimulationOf<D>::stable_step() const;
PF_INSTANTIATE(2)
PF_INSTANTIATE(3)
#undef PF_INSTANTIATE

}  // namespace pf
