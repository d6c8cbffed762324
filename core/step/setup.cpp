// From scene to particles, and what of a scene can change while it runs.
#include <algorithm>
#include <cmath>

#include "core/scene/sampling.hpp"
#include "core/scene/scene_io.hpp"
#include "core/scene/scene_view.hpp"
#include "core/step/balance.hpp"
#include "core/step/edge_planes.hpp"
#include "core/step/simulation_of.hpp"

namespace pf {

namespace {

template <int D>
std::unique_ptr<Law<D>> law_of(const Material& material) {
  std::vector<double> values;
  for (const auto& [key, value] : material.parameters) values.push_back(value);
  std::unique_ptr<Law<D>> law = make_law<D>(material.model, values);
  law->share_volume(material.f_bar);
  return law;
}

/// Of the mouse's spring, as a part of the held material's own stiffness: softer, so that a jerk moves bodies and does
/// not tear them.
constexpr double grab_softness = 0.1;

std::size_t material_index(const Scene& scene, const std::string& name) {
  for (std::size_t k = 0; k < scene.materials.size(); ++k)
    if (scene.materials[k].name == name) return k;
  throw InputError("", {{"/bodies", "material \"" + name + "\"", "a material of the scene", 0}});
}

}  // namespace

template <int D>
SimulationOf<D>::SimulationOf(const Scene& scene, const SimulationOptions& options)
    : scene_(scene),
      parallel_(options.threads),
      conditions_(scene),
      loads_(scene),
      known_(scene, conditions_),
      view_(std::make_shared<SceneView>(make_scene_view(scene))),
      end_(scene.time.end) {
  for (std::size_t k = 0; k < scene_.bodies.size(); ++k) add_body(k);
  make_settings();
  if (known_.known()) known_.set_initial_state(particles_);
  follow_probes({});
  make_control();
  plan_.set_domains({domain_edges(), domain_of_id_});
  plan_.set_edges(edge_planes(scene_, particles_));
  build_plan_or_throw();
  const FeasibleSet<D> set = conditions_.at(plan_, 0, 0);  // refuses contradictions before the first step
  if (!find_integrator(scene_.integrator.type)->inertia)
    if (const std::string loose = free_rigid_motion(plan_, set); !loose.empty())
      throw InputError("", {{"/integrator/type", "\"quasi_static\", but " + loose,
                             "constraints or boundaries that hold "
                             "every body against moving and turning, or an integrator with inertia",
                             0}});
  accepted_.linear_iterations = 0;
  describe_state(accepted_);
  control_->report(accepted_.control);
  show_grid_at_rest(set);
}

template <int D>
void SimulationOf<D>::show_grid_at_rest(const FeasibleSet<D>& set) {
  particles_to_grid(plan_, particles_, transfer_->affine(), parallel_, grid_);
  lumped_velocity(plan_, particles_, grid_);
  grid_.v_end = grid_.v;
  grid_.u = Vector::Zero(grid_.v.size());
  keep_grid(set);
}

template <int D>
void SimulationOf<D>::add_body(std::size_t index) {
  add_body(index, sample_body(scene_, index));
}

template <int D>
void SimulationOf<D>::add_body(std::size_t index, const Samples& samples) {
  const Body& body = scene_.bodies[index];
  const std::size_t material = material_index(scene_, body.material);
  const FormulaField<D> velocity(body.velocity, scene_.constants, mask_reference);
  const bool carried = !particles_.a.empty();
  if (!samples.domain.empty()) domain_of_id_.resize(came_, Mat<D>::Zero());
  for (std::size_t k = 0; k < samples.X.size(); ++k) {
    const Vec<D> X = samples.X[k].head<D>();
    if (!samples.domain.empty()) domain_of_id_.push_back(samples.domain[k].topLeftCorner<D, D>());
    particles_.X.push_back(X);
    particles_.x.push_back(X);
    particles_.v.push_back(velocity(X, X, 0));
    particles_.F.push_back(Mat<D>::Identity());
    particles_.C.push_back(Mat<D>::Zero());
    if (carried) particles_.a.push_back(Vec<D>::Zero());
    particles_.mass.push_back(scene_.materials[material].density * samples.volume[k]);
    particles_.volume0.push_back(samples.volume[k]);
    particles_.id.push_back(came_++);
    particles_.body.push_back(static_cast<std::uint16_t>(index));
    particles_.material.push_back(static_cast<std::uint16_t>(material));
  }
  if (samples.domain.empty()) return;
  auto shown = std::make_shared<std::vector<float>>();
  shown->reserve(domain_of_id_.size() * D * D);
  for (const Mat<D>& domain : domain_of_id_)
    for (int k = 0; k < D * D; ++k) shown->push_back(static_cast<float>(domain(k)));
  domains_shown_ = std::move(shown);
}

template <int D>
void SimulationOf<D>::follow_probes(const std::vector<Followed>& known) {
  std::vector<Followed> followed;
  for (const Probe& probe : scene_.probes) {
    const Vec<D> at = probe.at.head<D>();
    const auto before = std::find_if(known.begin(), known.end(), [&](const Followed& f) { return f.at == at; });
    if (before != known.end()) {
      followed.push_back(*before);
      continue;
    }
    // The order of the particles is that of the grid's blocks: of several that are as near, the first that came.
    const auto nearer = [&](std::size_t p, std::size_t q) {
      const double a = (particles_.X[p] - at).squaredNorm(), b = (particles_.X[q] - at).squaredNorm();
      return a != b ? a < b : particles_.id[p] < particles_.id[q];
    };
    std::size_t nearest = 0;
    for (std::size_t p = 1; p < particles_.size(); ++p)
      if (nearer(p, nearest)) nearest = p;
    followed.push_back({at, particles_.id[nearest]});
  }
  probes_ = std::move(followed);
}

template <int D>
void SimulationOf<D>::make_settings() {
  laws_.clear();
  elastic_memory_.rest_plan = -1;
  stable_ = {};
  for (const Material& material : scene_.materials) laws_.push_back(law_of<D>(material));
  // A velocity that is only reported is the way over dt, whatever the transfer.
  const bool inertia = find_integrator(scene_.integrator.type)->inertia;
  transfer_ =
      make_transfer<D>(inertia ? scene_.transfer.type : "pic", scene_.transfer.flip_ratio, scene_.transfer.order);
  integrator_ = make_integrator<D>(scene_.integrator.type, scene_.integrator.spectral_radius);
  if (!integrator_->carries_acceleration()) particles_.a.clear();
  chosen_solver_.clear();
  solves_ = {};
  loads_.set_gravity(scene_.gravity);
}

template <int D>
std::vector<double> SimulationOf<D>::domain_edges() const {
  std::vector<double> edges;  // points of a lattice stand for its cells, whatever their volume is made to add up to
  for (const Body& body : scene_.bodies)
    edges.push_back(body.sampling == "lattice" ? scene_.grid.spacing / body.particles_per_axis : 0);
  return edges;
}

template <int D>
void SimulationOf<D>::build_plan_or_throw() {
  if (!plan_.build(particles_, *find_basis(scene_.grid.basis), scene_.grid.spacing, parallel_))
    throw InputError("", {{"/bodies", "bodies too far apart for this grid spacing",
                           "positions below 1e15 spacings, all within about 2 million cells (3D) of each other", 0}});
}

namespace {

/// Whether lists agree in number and in what `same` compares.
template <class T, class Same>
bool alike(const std::vector<T>& a, const std::vector<T>& b, Same&& same) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

/// Whether `a` is all of `b`, and perhaps more after it.
bool extends(const std::vector<Body>& a, const std::vector<Body>& b) {
  return a.size() >= b.size() && std::equal(b.begin(), b.end(), a.begin());
}

/// Whether one list of walls is the beginning of the other.
bool share_walls(const std::vector<Boundary>& a, const std::vector<Boundary>& b) {
  const auto same = [](const Boundary& m, const Boundary& n) { return m.shape == n.shape && m.invert == n.invert; };
  return std::equal(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(std::min(a.size(), b.size())), b.begin(), same);
}

/// Constraints come and go; those of a list that stays as long stay where they are.
bool share_constraints(const std::vector<Constraint>& a, const std::vector<Constraint>& b) {
  return a.size() != b.size() ||
         alike(a, b, [](const Constraint& m, const Constraint& n) { return m.region == n.region; });
}

/// Whether all that particles, surfaces and the known motion were made from is the same; bodies may have come, the last
/// walls and any constraints have come or gone.
bool made_alike(const Scene& a, const Scene& b) {
  return a.dimension == b.dimension && a.constants == b.constants && a.grid.spacing == b.grid.spacing &&
         extends(a.bodies, b.bodies) && a.exact_position == b.exact_position && a.manufactured == b.manufactured &&
         alike(a.materials, b.materials,
               [](const Material& m, const Material& n) { return m.name == n.name && m.density == n.density; }) &&
         share_walls(a.boundaries, b.boundaries) && share_constraints(a.constraints, b.constraints) &&
         alike(a.loads, b.loads, [](const Load& m, const Load& n) { return m.body == n.body && m.region == n.region; });
}

}  // namespace

template <int D>
bool SimulationOf<D>::apply(const Scene& scene) {
  if (!made_alike(scene, scene_)) return false;
  const std::size_t bodies = scene_.bodies.size();
  const bool more = scene.bodies.size() > bodies;
  if (more && known_.known()) return false;  // a known motion is that of the bodies at its start
  std::vector<Samples> coming;               // refuses what has no particle while nothing has changed yet
  for (std::size_t k = bodies; k < scene.bodies.size(); ++k) coming.push_back(sample_body(scene, k));
  const bool walls = scene.boundaries != scene_.boundaries || scene.constraints != scene_.constraints;
  if (walls) {
    Conditions<D> changed(scene);
    // New walls stand where they were put.
    const std::vector<Vec<D>>& moved = conditions_.displacement();
    std::copy_n(moved.begin(), std::min(moved.size(), changed.displacement().size()), changed.displacement().begin());
    changed.at(plan_, time_, scene.time.step);  // refuses contradictions while nothing has changed yet
    conditions_ = std::move(changed);
  }
  if (scene.loads != scene_.loads || scene.body_force != scene_.body_force) loads_.set_formulas(scene);
  const bool was_affine = transfer_->affine(),
             basis = scene.grid != scene_.grid || (walls && scene.grid.boundary_correction);
  const bool looks = !alike(scene.boundaries, scene_.boundaries, [](const auto&, const auto&) { return true; }) ||
                     !alike(scene.constraints, scene_.constraints,
                            [](const Constraint& m, const Constraint& n) { return m.region == n.region; });
  const bool physics = scene.materials != scene_.materials || scene.gravity != scene_.gravity ||
                       scene.transfer != scene_.transfer || scene.integrator != scene_.integrator ||
                       scene.solver != scene_.solver;
  if (scene.time.end != scene_.time.end) end_ = scene.time.end;
  const bool probes = scene.probes != scene_.probes;
  const bool other_control = scene.time.control != scene_.time.control;
  // Adaptive control keeps what it knows where only loads, walls or the end have changed.
  const bool control = scene.time.control == "fixed" || other_control || physics || basis ||
                       scene.time.step != scene_.time.step || scene.time.tolerance != scene_.time.tolerance;
  scene_ = scene;
  if (basis) {
    plan_.set_edges(edge_planes(scene_, particles_));
    build_plan_or_throw();
  }
  if (physics || other_control) make_settings();
  for (std::size_t k = bodies; k < scene.bodies.size(); ++k) add_body(k, coming[k - bodies]);
  if (more || looks) view_ = std::make_shared<SceneView>(make_scene_view(scene_));
  if (more) {
    plan_.set_domains({domain_edges(), domain_of_id_});
    plan_.set_edges(edge_planes(scene_, particles_));
    build_plan_or_throw();
  }
  if (probes) follow_probes(probes_);
  if (control || more) make_control();
  if (was_affine && !transfer_->affine())
    for (Mat<D>& C : particles_.C) C.setZero();
  if (physics || basis || more) {
    const double before = accepted_.balance.total();
    accepted_.balance = particle_balance<D>(particles_, laws_, plan_, transfer_->affine(), loads_.gravity(), parallel_);
    if (!find_integrator(scene_.integrator.type)->inertia) accepted_.balance.kinetic = 0;
    edited_energy_ += accepted_.balance.total() - before;
  }
  return true;
}

template <int D>
void SimulationOf<D>::set_grab(const std::optional<Grab>& grab) {
  const bool again = grab && grab_ && grab->from == grab_->from && grab->radius == grab_->radius;
  grab_ = grab;
  if (!grab) {
    held_ = {};
    return;
  }
  if (again && !held_.id.empty()) return;
  // Smooth weights (1 - (r/R)^2)^2 by volume; the nearest particle alone where none is within reach.
  held_ = {};
  const Vec<D> from = grab->from.head<D>();
  double sum = 0, stiffness = 0;
  std::size_t nearest = 0;
  for (std::size_t p = 0; p < particles_.size(); ++p) {
    const double r2 = (particles_.x[p] - from).squaredNorm(), R2 = grab->radius * grab->radius;
    if (r2 < (particles_.x[nearest] - from).squaredNorm()) nearest = p;
    if (!(r2 < R2)) continue;
    const double w = (1 - r2 / R2) * (1 - r2 / R2) * particles_.volume0[p];
    held_.id.push_back(particles_.id[p]);
    held_.weight.push_back(w);
    sum += w;
    const Material& material = scene_.materials[particles_.material[p]];
    const double c = laws_[particles_.material[p]]->wave_speed(material.density);
    stiffness += w * material.density * c * c;
  }
  if (held_.id.empty()) {
    held_ = {{particles_.id[nearest]}, {1.0}};
    const Material& material = scene_.materials[particles_.material[nearest]];
    const double c = laws_[particles_.material[nearest]]->wave_speed(material.density);
    grab_stiffness_ = grab_softness * material.density * c * c * (D == 2 ? 1 : scene_.grid.spacing);
    return;
  }
  for (double& w : held_.weight) w /= sum;
  // In proportion to the held material: its modulus times its size (times unit thickness in 2D).
  grab_stiffness_ = grab_softness * stiffness / sum * (D == 2 ? 1 : grab->radius);
}

template <int D>
std::string SimulationOf<D>::solver_choice() const {
  return chosen_solver_.empty() ? "" : chosen_solver_ + (choice_reason_.empty() ? "" : ": " + choice_reason_);
}

template SimulationOf<2>::SimulationOf(const Scene&, const SimulationOptions&);
template SimulationOf<3>::SimulationOf(const Scene&, const SimulationOptions&);

#define PF_INSTANTIATE(D)                                                     \
  template void SimulationOf<D>::make_settings();                             \
  template void SimulationOf<D>::follow_probes(const std::vector<Followed>&); \
  template void SimulationOf<D>::show_grid_at_rest(const FeasibleSet<D>&);    \
  template void SimulationOf<D>::build_plan_or_throw();                       \
  template std::vector<double> SimulationOf<D>::domain_edges() const;         \
  template bool SimulationOf<D>::apply(const Scene&);                         \
  template void SimulationOf<D>::set_grab(const std::optional<Grab>&);        \
  template std::string SimulationOf<D>::solver_choice() const;
PF_INSTANTIATE(2)
PF_INSTANTIATE(3)
#undef PF_INSTANTIATE

}  // namespace pf
