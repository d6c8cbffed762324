// What others may see of the state: snapshots, probes, single particles.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/step/simulation_of.hpp"

namespace pf {

namespace {

template <int D>
Vec3 in_space(const Vec<D>& x) {
  Vec3 y = Vec3::Zero();
  y.head<D>() = x;
  return y;
}

}  // namespace

template <int D>
void SimulationOf<D>::keep_grid(const FeasibleSet<D>& set) {
  const auto n = static_cast<std::size_t>(plan_.node_count());
  last_grid_.index.resize(n);
  for (std::size_t i = 0; i < n; ++i) last_grid_.index[i] = plan_.node_index(static_cast<int>(i));
  last_grid_.mass = grid_.mass;
  last_grid_.v = grid_.v_end;
  last_grid_.u = grid_.u;
  last_grid_.state.assign(n, 0);
  for (const NodeConstraint<D>& c : set.constrained) {
    std::uint8_t& state = last_grid_.state[static_cast<std::size_t>(c.node)];
    const Vec<D> u = grid_.u.template segment<D>(c.node * D);
    bool touching = c.faces == 0 && !c.by_constraint;
    for (std::size_t k = 0; k < static_cast<std::size_t>(c.faces); ++k)
      touching = touching || c.normal[k].dot(u) - c.offset[k] <= 1e-12 * (u.norm() + std::abs(c.offset[k]));
    if (c.by_constraint) state |= 1;
    if (touching) state |= 2;
    if (c.faces > 0 && !touching) state |= 4;
  }
}

template <int D>
void SimulationOf<D>::capture_grid(Snapshot& into) const {
  const std::size_t n = last_grid_.index.size();
  into.nodes = n;
  into.node_index.resize(n * D);
  into.node_mass.resize(n);
  into.node_velocity.resize(n * D);
  into.node_displacement.resize(n * D);
  for (std::size_t i = 0; i < n; ++i) {
    into.node_mass[i] = last_grid_.mass[static_cast<Eigen::Index>(i)];
    for (std::size_t a = 0; a < D; ++a) {
      into.node_index[i * D + a] = static_cast<std::int32_t>(last_grid_.index[i][a]);
      into.node_velocity[i * D + a] = last_grid_.v[static_cast<Eigen::Index>(i * D + a)];
      into.node_displacement[i * D + a] = last_grid_.u[static_cast<Eigen::Index>(i * D + a)];
    }
  }
  into.node_state = last_grid_.state;
}

template <int D>
double SimulationOf<D>::recent_stable_step() const {
  constexpr long lasts = 50;
  const long step = accepted_.step;
  if (stable_.seconds == 0 || step < stable_.step || step >= stable_.step + lasts) stable_ = {step, stable_step()};
  return stable_.seconds;
}

template <int D>
void SimulationOf<D>::capture(const SnapshotRequest& request, Snapshot& into) const {
  const std::size_t n = particles_.size();
  into.dimension = D;
  into.spacing = scene_.grid.spacing;
  into.report = accepted_;
  into.particles = n;
  into.id = particles_.id;
  into.body = particles_.body;
  into.material = particles_.material;
  into.x.resize(n * D);
  into.F.resize(n * D * D);
  into.volume0.resize(n);
  for (std::size_t p = 0; p < n; ++p) {
    std::copy_n(particles_.x[p].data(), D, into.x.begin() + static_cast<std::ptrdiff_t>(p * D));
    for (std::size_t k = 0; k < D * D; ++k) into.F[p * D * D + k] = static_cast<float>(particles_.F[p].data()[k]);
    into.volume0[p] = static_cast<float>(particles_.volume0[p]);
  }
  into.domain = domains_shown_;
  into.v.clear();
  if (request.velocities)
    for (std::size_t p = 0; p < n; ++p)
      for (int a = 0; a < D; ++a) into.v.push_back(static_cast<float>(particles_.v[p][a]));
  into.X.clear();
  if (request.reference)
    for (const Vec<D>& X : particles_.X) into.X.insert(into.X.end(), X.data(), X.data() + D);
  into.probes = probes();
  into.nodes = 0;
  if (request.grid) capture_grid(into);
  capture_fields(request, into);
  into.stable_step = request.stable_step ? recent_stable_step() : 0;
  into.scene = view_;
  into.boundary_displacement.clear();
  for (const Vec<D>& d : conditions_.displacement()) into.boundary_displacement.push_back(in_space<D>(d));
  into.grabbed = grab_.has_value();
  if (!grab_) return;
  Vec<D> at = Vec<D>::Zero();
  for (std::size_t k = 0; k < held_.id.size(); ++k) {
    const auto found = std::find(particles_.id.begin(), particles_.id.end(), held_.id[k]);
    at += held_.weight[k] * particles_.x[static_cast<std::size_t>(found - particles_.id.begin())];
  }
  into.grab_at = in_space<D>(at);
  into.grab_target = grab_->to;
  into.grab_radius = grab_->radius;
}

template <int D>
ParticleState SimulationOf<D>::state_of(std::size_t p) const {
  ParticleState s;
  s.id = particles_.id[p];
  s.body = particles_.body[p];
  s.material = particles_.material[p];
  s.mass = particles_.mass[p];
  s.volume0 = particles_.volume0[p];
  s.X = in_space<D>(particles_.X[p]);
  s.x = in_space<D>(particles_.x[p]);
  s.v = in_space<D>(particles_.v[p]);
  s.F.topLeftCorner<D, D>() = particles_.F[p];
  const Law<D>& law = *laws_[s.material];
  s.sigma = law.cauchy(particles_.F[p]);
  law.energy({&particles_.F[p], 1}, {&s.energy_density, 1});
  return s;
}

template <int D>
std::vector<std::uint32_t> SimulationOf<D>::ranks() const {
  std::vector<std::uint32_t> rank(came_, 0);
  for (const std::uint32_t id : particles_.id) rank[id] = 1;
  std::exclusive_scan(rank.begin(), rank.end(), rank.begin(), std::uint32_t{0});
  return rank;
}

template <int D>
std::vector<ParticleState> SimulationOf<D>::particles() const {
  std::vector<ParticleState> states(particles_.size());
  const std::vector<std::uint32_t> rank = ranks();
  for (std::size_t p = 0; p < particles_.size(); ++p) states[rank[particles_.id[p]]] = state_of(p);
  return states;
}

template <int D>
ParticleState SimulationOf<D>::particle(std::uint32_t id) const {
  const std::size_t p = place_of(id);
  if (p == particles_.size()) throw std::out_of_range("no particle " + std::to_string(id));
  return state_of(p);
}

template <int D>
std::vector<ProbeReading> SimulationOf<D>::probes() const {
  std::vector<ProbeReading> readings;
  for (std::size_t k = 0; k < probes_.size(); ++k) {
    const std::size_t p = place_of(probes_[k].id);
    if (p == particles_.size()) continue;
    const ParticleState s = state_of(p);
    readings.push_back({k, s.id, s.x, s.v, s.sigma, s.X, s.F});
  }
  return readings;
}

#define PF_INSTANTIATE(D)                                                          \
  template void SimulationOf<D>::keep_grid(const FeasibleSet<D>&);                 \
  template double SimulationOf<D>::recent_stable_step() const;                     \
  template void SimulationOf<D>::capture(const SnapshotRequest&, Snapshot&) const; \
  template std::vector<ProbeReading> SimulationOf<D>::probes() const;              \
  template std::vector<std::uint32_t> SimulationOf<D>::ranks() const;              \
  template std::vector<ParticleState> SimulationOf<D>::particles() const;          \
  template ParticleState SimulationOf<D>::particle(std::uint32_t) const;
PF_INSTANTIATE(2)
PF_INSTANTIATE(3)
#undef PF_INSTANTIATE

}  // namespace pf
