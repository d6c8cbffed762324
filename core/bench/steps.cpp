#include "core/bench/steps.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/bench/clock.hpp"
#include "core/scene/scene_io.hpp"
#include "core/simulation.hpp"

namespace pf::bench {

namespace {

using Json = nlohmann::ordered_json;

Json point(int D, double x, double y, double z) {
  return D == 2 ? Json{x, y} : Json{x, y, z};
}

/// A bar of 2 (x 1) x 1 cells' edges times `edge`, in a grid of spacing 1 / edge.
Json bar(int D, std::string_view basis, std::size_t about_particles) {
  const int a_cell = D == 2 ? 4 : 8;
  const double cells = static_cast<double>(about_particles) / a_cell / 2;
  const double edge = std::max(2.0, std::round(std::pow(cells, 1.0 / D)));
  return {{"dimension", D},
          {"grid", {{"spacing", 1 / edge}, {"basis", basis}}},
          {"transfer", {{"type", "apic"}}},
          {"materials", {{"rubber", {{"model", "neo_hookean"}, {"density", 1000}, {"young", 1e5}, {"poisson", 0.3}}}}},
          {"bodies",
           Json::array({{{"name", "bar"},
                         {"material", "rubber"},
                         {"shape", {{"type", "box"}, {"min", point(D, 0, 0, 0)}, {"max", point(D, 2, 1, 1)}}}}})}};
}

StepResult measure(const Json& scene, std::string name, int threads, int steps) {
  const auto simulation = make_simulation(parse_scene(scene.dump(), "bench"), {threads});
  StepResult result;
  result.dimension = scene["dimension"];
  result.basis = scene["grid"]["basis"];
  result.name = std::move(name);
  result.particles = simulation->particle_count();
  result.threads = threads;
  result.steps = steps;
  std::vector<double> times;
  for (int k = 0; k <= steps; ++k) {
    const double begin = seconds(threads == 1);
    const StepReport& report = simulation->step();
    const double time = seconds(threads == 1) - begin;
    if (report.status != StepStatus::accepted) throw std::runtime_error("a step failed: " + report.failure);
    if (k == 0) continue;  // arrays are made in the first
    times.push_back(time);
    result.newton += (report.newton.empty() ? 0.0 : static_cast<double>(report.newton.size()) - 1) / steps;
    result.linear += static_cast<double>(report.linear_iterations) / steps;
    result.ms.sort += report.ms.sort / steps;
    result.ms.transfer += report.ms.transfer / steps;
    result.ms.assemble += report.ms.assemble / steps;
    result.ms.linear_solve += report.ms.linear_solve / steps;
    result.ms.update += report.ms.update / steps;
    result.ms.diagnostics += report.ms.diagnostics / steps;
    result.ms.total += report.ms.total / steps;
  }
  std::sort(times.begin(), times.end());
  const double each = 1e9 / static_cast<double>(result.particles);
  result.ns = times[times.size() / 2] * each;
  result.least_ns = times.front() * each;
  result.solver = simulation->solver_choice();
  return result;
}

}  // namespace

StepResult measure_explicit_step(int dimension, std::string_view basis, std::size_t about_particles, int threads,
                                 int steps) {
  Json scene = bar(dimension, basis, about_particles);
  const double speed = std::sqrt(1e5 / 1000 * (1 - 0.3) / (1.3 * 0.4)), spacing = scene["grid"]["spacing"];
  scene["time"] = {{"end", 1000}, {"step", spacing / speed / 3}};
  scene["integrator"] = {{"type", "symplectic_euler"}};
  scene["bodies"][0]["velocity"] = dimension == 2 ? Json{"1 - Y", "X"} : Json{"1 - Y", "X", "0.5"};
  return measure(scene, "explicit step", threads, steps);
}

StepResult measure_implicit_step(int dimension, std::string_view basis, std::size_t about_particles, int threads,
                                 int steps) {
  Json scene = bar(dimension, basis, about_particles);
  scene["time"] = {{"end", 1000}, {"step", 0.01}};
  scene["gravity"] = point(dimension, 0, -9.81, 0);
  scene["constraints"] = Json::array(
      {{{"region", {{"type", "box"}, {"min", point(dimension, -1, -1, -1)}, {"max", point(dimension, 0, 2, 2)}}},
        {"fix", dimension == 2 ? Json{true, true} : Json{true, true, true}}}});
  return measure(scene, "implicit step", threads, steps);
}

}  // namespace pf::bench
