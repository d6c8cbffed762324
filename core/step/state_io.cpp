// The complete state as bytes: a run that goes on from it gives the same bits.
#include <algorithm>
#include <istream>
#include <ostream>
#include <utility>

#include "core/scene/scene_io.hpp"
#include "core/step/edge_planes.hpp"
#include "core/step/simulation_of.hpp"

namespace pf {

namespace {

constexpr std::uint64_t magic = 0x3630657461745350;  // "PState06"

template <class T>
void put(std::ostream& out, const T& value) {
  out.write(reinterpret_cast<const char*>(&value), sizeof value);
}
template <class T>
void put(std::ostream& out, const std::vector<T>& values) {
  put(out, static_cast<std::uint64_t>(values.size()));
  out.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(T)));
}

/// Member by member: between them lies padding, whose bytes mean nothing.
template <int D>
void put(std::ostream& out, const std::vector<RubbingNode<D>>& nodes) {
  put(out, static_cast<std::uint64_t>(nodes.size()));
  for (const RubbingNode<D>& node : nodes) {
    put(out, node.index);
    put(out, node.normal);
    put(out, node.bound);
  }
}

void put(std::ostream& out, const StrokeSums& s) {
  put(out, static_cast<std::int64_t>(s.count));
  put(out, s.cut);
  put(out, s.painted);
  put(out, s.mass);
  put(out, s.energy);
  put(out, s.momentum);
}

[[noreturn]] void refuse(const std::string& what) {
  throw InputError("checkpoint", {{"", what, "the complete state of a run of this scene", 0}});
}

template <class T>
void get(std::istream& in, T& value) {
  if (!in.read(reinterpret_cast<char*>(&value), sizeof value)) refuse("a state that ends too early");
}
template <class T>
void read_values(std::istream& in, std::vector<T>& values, std::uint64_t count) {
  values.resize(count);
  if (!in.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T))))
    refuse("a state that ends too early");
}
template <class T>
void get(std::istream& in, std::vector<T>& values, std::size_t expected, bool optional = false) {
  std::uint64_t n = 0;
  get(in, n);
  if (n != expected && !(optional && n == 0)) refuse("a state of another size");
  read_values(in, values, n);
}
void get(std::istream& in, StrokeSums& s) {
  std::int64_t count = 0;
  get(in, count);
  s.count = count;
  get(in, s.cut);
  get(in, s.painted);
  get(in, s.mass);
  get(in, s.energy);
  get(in, s.momentum);
}
/// Each id once and below `came`, bodies and materials of the scene.
template <int D>
void check_names(const Particles<D>& particles, std::uint32_t came, const Scene& scene) {
  std::vector<char> taken(came, 0);
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const std::uint32_t id = particles.id[p];
    if (id >= came || taken[id]++ != 0 || particles.body[p] >= scene.bodies.size() ||
        particles.material[p] >= scene.materials.size())
      refuse("the state of another scene");
  }
}
/// Of a length that only the state knows.
template <int D>
void get(std::istream& in, std::vector<RubbingNode<D>>& nodes) {
  std::uint64_t n = 0;
  get(in, n);
  if (n > 1000000000 / sizeof(RubbingNode<D>)) refuse("a state of an impossible size");
  nodes.resize(n);
  for (RubbingNode<D>& node : nodes) {
    get(in, node.index);
    get(in, node.normal);
    get(in, node.bound);
  }
}

}  // namespace

namespace {

/// States tell the solver that was chosen last by a number that never changes its meaning.
constexpr std::string_view solver_codes[] = {"", "direct", "pcg_jacobi", "pcg_multigrid", "pcg_ic"};

std::int64_t solver_code(std::string_view name) {
  const auto at = std::find(std::begin(solver_codes), std::end(solver_codes), name);
  return at == std::end(solver_codes) ? 0 : at - std::begin(solver_codes);
}

std::string solver_of(std::int64_t code) {
  const bool known = code >= 0 && code < static_cast<std::int64_t>(std::size(solver_codes));
  return std::string(known ? solver_codes[code] : solver_codes[0]);
}

}  // namespace

template <int D>
void SimulationOf<D>::save_state(std::ostream& out) const {
  put(out, magic);
  put(out, static_cast<std::uint64_t>(D));
  put(out, static_cast<std::uint64_t>(came_));
  put(out, static_cast<std::uint64_t>(particles_.size()));
  put(out, strokes_);
  put(out, time_);
  put(out, static_cast<std::int64_t>(accepted_.step));
  // What "auto" has counted so far decides what it does next.
  put(out, solver_code(solves_.solver));
  put(out, std::array<double, 3>{solves_.jacobi, solves_.multigrid, solves_.steps});
  particles_.each([&](const auto& values) { put(out, values); });
  put(out, rubbing_);
  put(out, conditions_.displacement());
  put(out, loads_.surface().x);
  put(out, loads_.surface().area);
  put(out, known_.surface().x);
  put(out, control_->state());
  put(out, static_cast<std::uint64_t>(probes_.size()));
  for (const Followed& probe : probes_) {
    put(out, probe.at);
    put(out, probe.id);
  }
}

template <int D>
void SimulationOf<D>::load_state(std::istream& in) {
  std::uint64_t mark = 0, dimension = 0, came = 0, count = 0;
  get(in, mark);
  if (mark != magic) refuse("something else than a saved state, or one of another version");
  get(in, dimension);
  get(in, came);
  get(in, count);
  // Of those that came some may have been cut away, here and there.
  if (dimension != D || came != came_ || count == 0 || count > came) refuse("the state of another scene");
  StrokeSums strokes;
  get(in, strokes);
  Particles<D> loaded;
  double time = 0;
  std::int64_t step = 0, solver = 0;
  std::array<double, 3> solves{};
  get(in, time);
  get(in, step);
  get(in, solver);
  get(in, solves);
  loaded.each([&](auto& values) {
    // Only some time schemes carry an acceleration, and these not before their first step.
    const bool optional = static_cast<void*>(&values) == &loaded.a;
    get(in, values, count, optional);
  });
  check_names(loaded, came_, scene_);
  if (!integrator_->carries_acceleration()) loaded.a.clear();
  std::vector<RubbingNode<D>> rubbing;
  get(in, rubbing);
  std::vector<Vec<D>> displacement, surface, manufactured;
  std::vector<double> area;
  get(in, displacement, conditions_.displacement().size());
  get(in, surface, loads_.surface().x.size());
  get(in, area, loads_.surface().area.size());
  get(in, manufactured, known_.surface().x.size());
  std::uint64_t numbers = 0;
  get(in, numbers);
  if (numbers > 1000000000) refuse("a state of an impossible size");
  std::vector<double> steps;
  read_values(in, steps, numbers);
  std::vector<Followed> probes;
  get(in, numbers);
  if (numbers > 1000000) refuse("a state of an impossible size");
  for (std::uint64_t k = 0; k < numbers; ++k) {
    get(in, probes.emplace_back().at);
    get(in, probes.back().id);
  }
  const double size = std::exchange(size_, size_of(loaded, scene_.grid.spacing));
  std::unique_ptr<StepControl> control = new_control();
  if (!control->set_state(steps)) {
    size_ = size;
    refuse("a state of another step control");
  }
  particles_ = std::move(loaded);
  rubbing_ = std::move(rubbing);
  conditions_.displacement() = std::move(displacement);
  loads_.surface().x = std::move(surface);
  loads_.surface().area = std::move(area);
  known_.surface().x = std::move(manufactured);
  time_ = time;
  control_ = std::move(control);
  follow_probes(probes);
  plan_.set_edges(edge_planes(scene_, particles_));
  build_plan_or_throw();
  accepted_ = {};
  strokes_ = strokes;
  edited_energy_ = stroked_energy_ = 0;
  stroked_angular_.setZero();
  accepted_.step = step;
  describe_state(accepted_);
  control_->report(accepted_.control);
  accepted_.active_nodes = plan_.node_count();
  chosen_solver_ = solver_of(solver);
  solves_ = {chosen_solver_, solves[0], solves[1], solves[2]};
  show_grid_at_rest(conditions_.at(plan_, time_, 0));
}

template void SimulationOf<2>::save_state(std::ostream&) const;
template void SimulationOf<3>::save_state(std::ostream&) const;
template void SimulationOf<2>::load_state(std::istream&);
template void SimulationOf<3>::load_state(std::istream&);

}  // namespace pf
