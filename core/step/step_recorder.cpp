#include "core/step/step_recorder.hpp"

#include <algorithm>

#include "core/step/plan_weights.hpp"

namespace pf {

namespace {

std::vector<double> numbers(const Vector& v) {
  return {v.data(), v.data() + v.size()};
}
template <class Array>
std::vector<double> numbers(const Array* first, std::size_t count) {
  const double* const begin = first->data();
  return {begin, begin + count * static_cast<std::size_t>(first->size())};
}

}  // namespace

template <int D>
StepRecorder<D>::StepRecorder(RecordLevel level, const Plan<D>& plan, const Particles<D>& particles,
                              const Laws<D>& laws, const GridState<D>& grid, const MassKind& mass, Parallel& parallel)
    : level_(level),
      plan_(plan),
      particles_(particles),
      grid_(grid),
      mass_(plan, particles, grid.mass, level == RecordLevel::all ? mass : MassKind{}, parallel, work_),
      elastic_(plan, particles, laws, parallel, work_) {}

template <int D>
void StepRecorder<D>::begin_step(long step, double time, double dt, StepConditions<D>& conditions) {
  StepRecord& r = *record_;
  r.dimension = D;
  r.spacing = plan_.spacing();
  r.step = step;
  r.time = time;
  r.dt = dt;
  for (const auto& index : plan_.node_indices())
    for (const long long i : index) r.node_index.push_back(static_cast<std::int32_t>(i));
  r.node_mass = numbers(grid_.mass);
  if (!all()) return;
  r.node_velocity = numbers(grid_.v);
  Vector force, inner = Vector::Zero(grid_.v.size());
  conditions.force(0, force);
  r.external_start = numbers(force);
  elastic_.add_force_at_rest(inner);
  r.internal_start = numbers(-inner);
  const std::size_t n = particles_.size();
  r.id = particles_.id;
  r.particle_mass = particles_.mass;
  keep_weights();
  r.before = {numbers(particles_.x.data(), n), numbers(particles_.v.data(), n), numbers(particles_.F.data(), n)};
}

template <int D>
void StepRecorder<D>::keep_weights() {
  StepRecord& r = *record_;
  r.nodes_per_axis = plan_.nodes_per_axis();
  for (std::size_t p = 0; p < particles_.size(); ++p) {
    const std::vector<NodeWeight> nodes = weights_in(plan_, p);
    if (p == 0) r.weights.reserve(particles_.size() * nodes.size() * (1 + D));
    for (std::size_t a = 0; a < D; ++a) r.first_node.push_back(nodes.front().node[a]);
    for (const NodeWeight& n : nodes) {
      r.weights.push_back(static_cast<float>(n.w));
      for (int a = 0; a < D; ++a) r.weights.push_back(static_cast<float>(n.grad[a]));
    }
  }
}

template <int D>
void StepRecorder<D>::stage(double scale, const Vector& u_free, const Vector& loads, const Vector* inner) {
  StageRecord stage;
  stage.scale = scale;
  if (all()) {
    stage.u_free = numbers(u_free);
    stage.given = numbers(inner ? Vector(loads + *inner) : loads);
  }
  record_->stages.push_back(std::move(stage));
}

template <int D>
void StepRecorder<D>::begin() {
  if (!superseded_.empty()) superseded_.back() = true;
}

template <int D>
void StepRecorder<D>::find_worst(const Vector& left, IterateRecord& iterate) const {
  const double least = 1e-9 * grid_.mass.maxCoeff();
  double sum = 0, most = 0;
  for (Eigen::Index i = 0; i < grid_.mass.size(); ++i) {
    const double part = left.segment<D>(i * D).squaredNorm() / std::max(grid_.mass[i], least);
    sum += part;
    if (!(part > most)) continue;
    most = part;
    iterate.worst = static_cast<std::int32_t>(i);
  }
  if (sum > 0) iterate.worst_share = most / sum;
}

template <int D>
void StepRecorder<D>::iterate(const Vector& u, const Vector& left, const NewtonIteration& record) {
  StepRecord& r = *record_;
  IterateRecord it;
  it.stage = r.stages.empty() ? 0 : r.stages.size() - 1;
  it.newton = record;
  find_worst(left, it);
  // Of iterates before the last only their worst place is kept unless all is asked for.
  if (!all() && !r.iterates.empty()) r.iterates.back().residual.clear();
  it.residual = numbers(left);
  if (all()) {
    it.u = numbers(u);
    const StageRecord& stage = r.stages[it.stage];
    Vector product, inner = Vector::Zero(u.size()), magnitude = Vector::Zero(grid_.mass.size());
    mass_.multiply(u - Eigen::Map<const Vector>(stage.u_free.data(), u.size()), product);
    it.inertia = numbers(stage.scale * product);
    elastic_.gradient(u, inner, magnitude);
    it.internal = numbers(-inner);
  }
  r.iterates.push_back(std::move(it));
  superseded_.push_back(false);
}

template <int D>
std::shared_ptr<const StepRecord> StepRecorder<D>::solved(const std::vector<NewtonIteration>& iterations) {
  std::size_t k = 0;
  for (std::size_t i = 0; i < record_->iterates.size(); ++i)
    if (!superseded_[i] && k < iterations.size()) record_->iterates[i].newton = iterations[k++];
  if (all()) {
    record_->node_displacement = numbers(grid_.u);
    record_->node_velocity_end = numbers(grid_.v_end);
  }
  return record_;
}

template <int D>
void StepRecorder<D>::moved(const Motion<D>& to) {
  record_->accepted = true;
  if (!all()) return;
  // Positions stand in the present order, the rest in the next plan's where it is foreseen.
  const std::size_t n = particles_.size();
  record_->after.x = numbers(to.x, n);
  for (std::size_t p = 0; p < n; ++p) {
    const std::size_t at = to.place ? to.place[p] : p;
    const Mat<D>& F = to.F ? to.F[at] : particles_.F[p];
    record_->after.v.insert(record_->after.v.end(), to.v[at].data(), to.v[at].data() + D);
    record_->after.F.insert(record_->after.F.end(), F.data(), F.data() + D * D);
  }
}

template class StepRecorder<2>;
template class StepRecorder<3>;

}  // namespace pf
