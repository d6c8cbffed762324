// pushforward bench: kernels and whole steps next to what the machine can do.
#include <cstdio>
#include <thread>

#include "app/cli/commands.hpp"
#include "core/bases/basis.hpp"
#include "core/bench/report.hpp"
#include "core/files.hpp"

namespace pf::app {

namespace {

void show(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  std::fflush(stdout);
}

}  // namespace

int run_bench(const BenchOptions& options) {
  const int all = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int threads = options.threads.value_or(1);
  const bool quick = options.quick;
  const std::size_t in_2d = options.particles.value_or(quick ? 10'000 : 100'000);
  const std::size_t in_3d = options.particles.value_or(quick ? 20'000 : 500'000);
  const double budget = quick ? 0.02 : 0.3;
  const bench::Machine machine = bench::measure_machine(std::max(all, threads), quick);
  show(text(machine));
  nlohmann::ordered_json result{{"format", "pushforward/bench"},
                                {"version", 1},
                                {"machine", bench::to_json(machine)},
                                {"kernels", nlohmann::ordered_json::array()},
                                {"steps", nlohmann::ordered_json::array()}};
  const auto wanted = [&](int dimension, std::string_view basis) {
    return (!options.dimension || *options.dimension == dimension) && (!options.basis || *options.basis == basis);
  };
  const auto particles = [&](int dimension) { return dimension == 2 ? in_2d : in_3d; };
  for (const int dimension : {2, 3})
    for (const BasisInfo& basis : bases()) {
      if (!wanted(dimension, basis.name)) continue;
      const bench::KernelCase measured =
          bench::measure_kernels(dimension, basis.name, particles(dimension), threads, budget);
      show(text(machine, measured));
      result["kernels"].push_back(bench::to_json(machine, measured));
    }
  show(bench::step_heading());
  const auto add_step = [&](const bench::StepResult& measured) {
    show(text(measured));
    result["steps"].push_back(bench::to_json(measured));
  };
  for (const int dimension : {2, 3})
    for (const BasisInfo& basis : bases()) {
      if (!wanted(dimension, basis.name)) continue;
      add_step(bench::measure_explicit_step(dimension, basis.name, particles(dimension), threads, quick ? 3 : 8));
      add_step(bench::measure_implicit_step(dimension, basis.name, particles(dimension) / 4, threads, quick ? 2 : 4));
    }
  if (options.json) write_atomically(*options.json, result.dump(2) + "\n");
  return exit_done;
}

}  // namespace pf::app
