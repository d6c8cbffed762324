// The complete state as bytes: a run that goes on from it gives the same bits.
#include <algorithm>
#include <istream>
#include <ostream>

#include "core/scene/scene_io.hpp"
#include "core/step/simulation_of.hpp"

namespace pf {

namespace {

constexpr std::uint64_t magic = 0x3530657461745350;  // "PState05"

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
  put(out, static_cast<std::uint64_t>(particles_.size()));
  put(out, time_);
  put(out, static_cast<std::int64_t>(accepted_.step));
  // What "auto" has counted so far decides what it does next.
  put(out, solver_code(solves_.solver));
  put(out, std::array<double, 3>{solves_.jacobi, solves_.multigrid, solves_.steps});
  particles_.each([&](const auto& values) { put(out, values); });
  put(out, rubbing_);
  put(out, conditions_.displacement());
  put(out, loads_.surface().x);
  put(out, known_.surface().x);
  put(out, control_->state());
}

template <int D>
void SimulationOf<D>::load_state(std::istream& in) {
  std::uint64_t mark = 0, dimension = 0, count = 0;
  get(in, mark);
  if (mark != magic) refuse("something else than a saved state, or one of another version");
  get(in, dimension);
  get(in, count);
  if (dimension != D || count != particles_.size()) refuse("the state of another scene");
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
    get(in, values, particles_.size(), optional);
  });
  if (!integrator_->carries_acceleration()) loaded.a.clear();
  std::vector<RubbingNode<D>> rubbing;
  get(in, rubbing);
  std::vector<Vec<D>> displacement, surface, manufactured;
  get(in, displacement, conditions_.displacement().size());
  get(in, surface, loads_.surface().x.size());
  get(in, manufactured, known_.surface().x.size());
  std::uint64_t numbers = 0;
  get(in, numbers);
  if (numbers > 1000000000) refuse("a state of an impossible size");
  std::vector<double> steps;
  read_values(in, steps, numbers);
  std::unique_ptr<StepControl> control = new_control();
  if (!control->set_state(steps)) refuse("a state of another step control");
  particles_ = std::move(loaded);
  rubbing_ = std::move(rubbing);
  conditions_.displacement() = std::move(displacement);
  loads_.surface().x = std::move(surface);
  known_.surface().x = std::move(manufactured);
  time_ = time;
  control_ = std::move(control);
  build_plan_or_throw();
  accepted_ = {};
  edited_energy_ = 0;
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
