// What the simulation tells of one particle and one node.
#include "core/look.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "core/step/plan_weights.hpp"
#include "core/step/simulation_of.hpp"

namespace pf {

namespace {

template <int D>
Vec3 in_space(const Vec<D>& x) {
  Vec3 y = Vec3::Zero();
  y.head<D>() = x;
  return y;
}

/// The residual that a recorded step left at a node.
std::optional<Vec3> residual_at(const StepRecord* record, const NodeIndex& node) {
  if (record == nullptr || record->iterates.empty()) return std::nullopt;
  const std::vector<double>& left = record->iterates.back().residual;
  const auto d = static_cast<std::size_t>(record->dimension);
  for (std::size_t i = 0; i < record->nodes(); ++i) {
    if (!std::equal(node.begin(), node.begin() + record->dimension,
                    record->node_index.begin() + static_cast<long>(i * d)))
      continue;
    Vec3 r = Vec3::Zero();
    for (std::size_t a = 0; a < d; ++a) r[static_cast<int>(a)] = left[i * d + a];
    return r;
  }
  return std::nullopt;
}

}  // namespace

template <int D>
ParticleLook SimulationOf<D>::look_at_particle(std::uint32_t id) const {
  ParticleLook look;
  look.state = particle(id);
  const Mat<D> F = look.state.F.template topLeftCorner<D, D>();
  look.J = F.determinant();
  look.stretches.template head<D>() = Eigen::JacobiSVD<Mat<D>>(F).singularValues();
  look.energy = look.state.volume0 * look.state.energy_density;
  const auto found = std::find(particles_.id.begin(), particles_.id.end(), id);
  look.nodes = weights_in(plan_, static_cast<std::size_t>(found - particles_.id.begin()));
  for (const NodeWeight& n : look.nodes) {
    look.weight_sum += n.w;
    look.gradient_sum += n.grad;
    for (int a = 0; a < D; ++a) look.position_sum[a] += n.w * scene_.grid.spacing * n.node[static_cast<std::size_t>(a)];
  }
  return look;
}

template <int D>
NodeLook SimulationOf<D>::look_at_node(const NodeIndex& index) const {
  NodeLook look;
  look.node = index;
  const double dx = scene_.grid.spacing;
  std::array<long long, D> lattice;
  for (std::size_t a = 0; a < D; ++a) {
    lattice[a] = index[a];
    look.x[static_cast<int>(a)] = dx * index[a];
  }
  const int node = plan_.find_node(lattice);
  look.active = node >= 0;
  if (!look.active) return look;
  GridState<D> grid;
  particles_to_grid(plan_, particles_, transfer_->affine(), parallel_, grid);
  lumped_velocity(plan_, particles_, grid);
  look.mass = grid.mass[node];
  look.velocity = in_space<D>(grid.v.template segment<D>(node * D));
  Vector force;
  loads_.force(plan_, particles_, grid.mass, time_, parallel_, force);
  if (known_.manufactured()) known_.add_force(plan_, particles_, laws_, scene_, time_, parallel_, force);
  look.external = in_space<D>(force.template segment<D>(node * D));
  look.residual = residual_at(record_.get(), index);

  const double reach = (0.5 * plan_.nodes_per_axis() + 1e-9) * dx;
  for (std::size_t p = 0; p < particles_.size(); ++p) {
    const Vec<D> offset = look.x.template head<D>() - particles_.x[p];
    if (!(offset.cwiseAbs().maxCoeff() < reach)) continue;
    const std::vector<NodeWeight> around = weights_in(plan_, p);
    const auto here = std::find_if(around.begin(), around.end(), [&](const NodeWeight& n) { return n.node == index; });
    if (here == around.end() || (here->w == 0 && here->grad.isZero(0))) continue;
    Contribution c;
    c.particle = particles_.id[p];
    c.w = here->w;
    c.mass = particles_.mass[p] * here->w;
    Vec<D> v = particles_.v[p];
    if (transfer_->affine()) v += particles_.C[p] * offset;
    c.momentum = c.mass * in_space<D>(v);
    double psi = 0;
    Mat<D> P;
    laws_[particles_.material[p]]->stress({&particles_.F[p], 1}, {&psi, 1}, {&P, 1});
    const Vec<D> f = -particles_.volume0[p] * (P * (particles_.F[p].transpose() * here->grad.template head<D>()));
    c.force = in_space<D>(f);
    look.internal += c.force;
    ++look.contributors;
    look.largest.push_back(c);
  }
  std::sort(look.largest.begin(), look.largest.end(), [](const Contribution& a, const Contribution& b) {
    return a.mass != b.mass ? a.mass > b.mass : a.particle < b.particle;
  });
  if (look.largest.size() > most_contributions) look.largest.resize(most_contributions);
  return look;
}

template <int D>
Look SimulationOf<D>::look(const LookQuestion& question) const {
  Look look;
  look.step = accepted_.step;
  look.time = time_;
  if (question.particle && has_particle(*question.particle)) look.particle = look_at_particle(*question.particle);
  if (question.node) look.node = look_at_node(*question.node);
  return look;
}

template Look SimulationOf<2>::look(const LookQuestion&) const;
template Look SimulationOf<3>::look(const LookQuestion&) const;

}  // namespace pf
