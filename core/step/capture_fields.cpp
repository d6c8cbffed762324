// The fields of a snapshot. Only those asked for are worked out, and of what they need, only that.
#include <Eigen/LU>
#include <algorithm>
#include <limits>

#include "core/diagnostics/strain.hpp"
#include "core/diagnostics/stress.hpp"
#include "core/energies/elastic.hpp"
#include "core/step/simulation_of.hpp"

namespace pf {

namespace {

constexpr std::array<std::array<int, 2>, 6> tensor_entries{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};

/// Which of a row of fields that follow one another `field` is, `first` being 0.
constexpr int place(Field field, Field first) {
  return static_cast<int>(field) - static_cast<int>(first);
}
constexpr bool between(Field field, Field first, Field last) {
  return field >= first && field <= last;
}

bool of_stress(Field f) {
  return f == Field::von_mises || f == Field::pressure || between(f, Field::stress_1, Field::stress_xz);
}

double stress_value(Field f, const Mat3& sigma) {
  if (f == Field::von_mises) return von_mises(sigma);
  if (f == Field::pressure) return pressure(sigma);
  if (between(f, Field::stress_xx, Field::stress_xz)) {
    const auto [a, b] = tensor_entries[static_cast<std::size_t>(place(f, Field::stress_xx))];
    return sigma(a, b);
  }
  const Vec3 s = principal_values<3>(sigma);
  return f == Field::shear ? 0.5 * (s[0] - s[2]) : s[place(f, Field::stress_1)];
}

template <int D>
double strain_value(Field f, const Mat<D>& F) {
  if (f == Field::J) return F.determinant();
  if (f == Field::strain_equivalent) return equivalent_strain<D>(F);
  if (between(f, Field::stretch_1, Field::stretch_3)) {
    const int k = place(f, Field::stretch_1);
    return k < D ? principal_stretches<D>(F)[k] : 1;
  }
  const auto [a, b] = tensor_entries[static_cast<std::size_t>(place(f, Field::strain_xx))];
  return a < D && b < D ? green_strain<D>(F)(a, b) : 0;
}

template <int D>
double component(const Vec<D>& v, int a) {
  return a < D ? v[a] : 0;
}

template <int D>
double motion_value(Field f, const Vec<D>& v, const Vec<D>& u, double density) {
  if (f == Field::speed) return v.norm();
  if (f == Field::kinetic_density) return 0.5 * density * v.squaredNorm();
  if (f == Field::displacement) return u.norm();
  if (between(f, Field::velocity_x, Field::velocity_z)) return component<D>(v, place(f, Field::velocity_x));
  return component<D>(u, place(f, Field::displacement_x));
}

}  // namespace

template <int D>
void SimulationOf<D>::capture_fields(const SnapshotRequest& request, Snapshot& into) const {
  const std::size_t n = particles_.size();
  std::vector<Field> of_sigma, of_nodes;
  into.stress.resize(request.stress ? 6 * n : 0);
  for (const FieldInfo& info : fields()) {
    const Field f = info.field;
    std::vector<float>& values = into.field[static_cast<std::size_t>(f)];
    values.clear();
    if ((request.fields & field_bit(f)) == 0) continue;
    if (info.on_nodes) {
      if (request.grid) of_nodes.push_back(f);
      continue;
    }
    values.resize(n);
    if (of_stress(f))
      of_sigma.push_back(f);
    else if (f != Field::energy_density && f != Field::error)
      for (std::size_t p = 0; p < n; ++p) values[p] = static_cast<float>(plain_value(f, p));
  }
  if ((request.fields & field_bit(Field::error)) != 0) {
    std::vector<double> error(n, 0.0);
    if (known_.known()) known_.displacement_errors(particles_, time_, error);
    std::copy(error.begin(), error.end(), into.field[static_cast<std::size_t>(Field::error)].begin());
  }
  const bool energy = (request.fields & field_bit(Field::energy_density)) != 0;
  if (energy || request.stress || !of_sigma.empty()) capture_stress(of_sigma, energy, into);
  if (!of_nodes.empty()) capture_node_fields(of_nodes, into);
}

template <int D>
double SimulationOf<D>::plain_value(Field f, std::size_t p) const {
  if (f == Field::material) return particles_.material[p];
  if (f == Field::J || between(f, Field::stretch_1, Field::strain_xz)) return strain_value<D>(f, particles_.F[p]);
  const double density = particles_.mass[p] / (particles_.volume0[p] * particles_.F[p].determinant());
  return motion_value<D>(f, particles_.v[p], particles_.x[p] - particles_.X[p], density);
}

template <int D>
void SimulationOf<D>::capture_stress(std::span<const Field> wanted, bool energy, Snapshot& into) const {
  for (const MaterialRun& run : plan_.runs()) {
    double psi[longest_run];
    Mat3 sigma[longest_run];
    const auto first = static_cast<std::size_t>(run.begin), count = static_cast<std::size_t>(run.end - run.begin);
    const std::span<const Mat<D>> F{particles_.F.data() + first, count};
    if (energy) laws_[run.material]->energy(F, {psi, count});
    if (!wanted.empty() || !into.stress.empty()) laws_[run.material]->cauchy(F, {sigma, count});
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t p = first + k;
      if (energy) into.field[static_cast<std::size_t>(Field::energy_density)][p] = static_cast<float>(psi[k]);
      for (const Field f : wanted)
        into.field[static_cast<std::size_t>(f)][p] = static_cast<float>(stress_value(f, sigma[k]));
      if (into.stress.empty()) continue;
      for (std::size_t c = 0; c < 6; ++c)
        into.stress[6 * p + c] = static_cast<float>(sigma[k](tensor_entries[c][0], tensor_entries[c][1]));
    }
  }
}

template <int D>
void SimulationOf<D>::capture_node_fields(std::span<const Field> wanted, Snapshot& into) const {
  const std::size_t n = last_grid_.index.size();
  const auto vector_at = [](const Vector& all, std::size_t i) -> Vec<D> {
    return all.template segment<D>(static_cast<Eigen::Index>(i * D));
  };
  Vector force;
  for (const Field f : wanted) {
    std::vector<float>& values = into.field[static_cast<std::size_t>(f)];
    values.assign(n, std::numeric_limits<float>::quiet_NaN());
    const bool forces = between(f, Field::node_force, Field::node_force_z);
    if (forces && force.size() == 0) force = internal_force();
    for (std::size_t i = 0; i < n; ++i) {
      double value = 0;
      if (f == Field::node_mass) {
        value = last_grid_.mass[static_cast<Eigen::Index>(i)];
      } else if (f == Field::node_residual) {
        if (!record_ || record_->iterates.empty() || record_->iterates.back().residual.size() != n * D) break;
        value = Eigen::Map<const Vec<D>>(record_->iterates.back().residual.data() + i * D).norm();
      } else if (forces) {
        const int node = plan_.find_node(last_grid_.index[i]);  // of the state at hand, which may have left this one
        const Vec<D> at = node < 0 ? Vec<D>::Zero().eval() : vector_at(force, static_cast<std::size_t>(node));
        value = f == Field::node_force ? at.norm() : component<D>(at, place(f, Field::node_force_x));
      } else if (f == Field::node_displacement) {
        value = vector_at(last_grid_.u, i).norm();
      } else {
        const Vec<D> v = vector_at(last_grid_.v, i);
        value = f == Field::node_speed ? v.norm() : component<D>(v, place(f, Field::node_velocity_x));
      }
      values[i] = static_cast<float>(value);
    }
  }
}

template <int D>
Vector SimulationOf<D>::internal_force() const {
  Work uncounted;
  ElasticEnergy<D> elastic(plan_, particles_, laws_, parallel_, uncounted);
  Vector gradient = Vector::Zero(plan_.node_count() * D);
  elastic.add_force_at_rest(gradient);
  return -gradient;
}

template void SimulationOf<2>::capture_fields(const SnapshotRequest&, Snapshot&) const;
template void SimulationOf<3>::capture_fields(const SnapshotRequest&, Snapshot&) const;

}  // namespace pf
