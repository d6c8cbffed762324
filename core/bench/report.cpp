#include "core/bench/report.hpp"

#include <algorithm>
#include <cstdio>

#include "core/build_info.hpp"

namespace pf::bench {

namespace {

template <class... Values>
std::string format(const char* pattern, Values... values) {
  char line[512];
  std::snprintf(line, sizeof line, pattern, values...);
  return line;
}

}  // namespace

double roofline_ns(const Machine& machine, const Counts& counts, int threads) {
  return 1e9 * std::max(counts.bytes / machine.bandwidth(threads), counts.flops / machine.flops(threads));
}

std::string text(const Machine& machine) {
  std::string out = machine.cpu + format(", %d thread%s\n", machine.threads, machine.threads == 1 ? "" : "s");
  out += "                                   1 thread   all threads\n";
  for (const Triad& triad : machine.triad)
    out += format("  triad, %6.0f MB            %8.1f      %8.1f   GB/s\n", triad.bytes / 1e6, triad.one_thread / 1e9,
                  triad.all_threads / 1e9);
  out += format("  multiply-add, double        %8.1f      %8.1f   Gflop/s\n", machine.fma_one_thread / 1e9,
                machine.fma_all_threads / 1e9);
  return out;
}

std::string text(const Machine& machine, const KernelCase& measured) {
  std::string out = format("\n%dD %s, %zu particles, %d nodes, %d thread%s, %.0f MB\n", measured.dimension,
                           measured.basis.c_str(), measured.particles, measured.nodes, measured.threads,
                           measured.threads == 1 ? "" : "s", measured.bytes / 1e6);
  out += "  a particle                             ns  least ns   bytes   flops  roofline ns  fraction\n";
  for (const KernelResult& k : measured.kernels) {
    out += format("  %-36s %8.1f  %8.1f", k.name.c_str(), k.ns, k.least_ns);
    if (k.counts.bytes > 0) {
      const double limit = roofline_ns(machine, k.counts, measured.threads);
      out += format("  %6.0f  %6.0f  %11.1f     %5.2f", k.counts.bytes, k.counts.flops, limit, limit / k.ns);
    }
    out += "\n";
  }
  return out;
}

std::string step_heading() {
  return "\nWhole steps                        particles  threads  ns a particle     least  Newton  linear  solver\n";
}

std::string text(const StepResult& s) {
  std::string out = format("  %dD %-10s %-18s %10zu  %7d  %13.1f  %8.1f  %6.1f  %6.1f  %s\n", s.dimension,
                           s.basis.c_str(), s.name.c_str(), s.particles, s.threads, s.ns, s.least_ns, s.newton,
                           s.linear, s.newton > 0 ? s.solver.c_str() : "");
  out += format("      ms: to grid %.1f, conditions %.1f, solve %.1f, to particles %.1f, sort %.1f, diagnostics %.1f\n",
                s.ms.transfer, s.ms.assemble, s.ms.linear_solve, s.ms.update, s.ms.sort, s.ms.diagnostics);
  return out;
}

nlohmann::ordered_json to_json(const Machine& machine) {
  nlohmann::ordered_json triad = nlohmann::ordered_json::array();
  for (const Triad& t : machine.triad)
    triad.push_back({{"bytes", t.bytes}, {"one_thread_B_s", t.one_thread}, {"all_threads_B_s", t.all_threads}});
  const BuildInfo build = build_info();
  return {{"cpu", machine.cpu},
          {"threads", machine.threads},
          {"triad", triad},
          {"fma_one_thread_flop_s", machine.fma_one_thread},
          {"fma_all_threads_flop_s", machine.fma_all_threads},
          {"version", std::string(build.version)},
          {"commit", std::string(build.commit)},
          {"compiler", std::string(build.compiler)},
          {"flags", std::string(build.flags)}};
}

nlohmann::ordered_json to_json(const Machine& machine, const KernelCase& measured) {
  nlohmann::ordered_json kernels = nlohmann::ordered_json::array();
  for (const KernelResult& k : measured.kernels) {
    nlohmann::ordered_json entry{
        {"name", k.name}, {"ns_per_particle", k.ns}, {"least_ns_per_particle", k.least_ns}, {"repeats", k.repeats}};
    if (k.counts.bytes > 0) {
      const double limit = roofline_ns(machine, k.counts, measured.threads);
      entry["bytes"] = k.counts.bytes;
      entry["flops"] = k.counts.flops;
      entry["roofline_ns"] = limit;
      entry["roofline_fraction"] = limit / k.ns;
    }
    kernels.push_back(std::move(entry));
  }
  return {{"dimension", measured.dimension},
          {"basis", measured.basis},
          {"particles", measured.particles},
          {"nodes", measured.nodes},
          {"threads", measured.threads},
          {"bytes", measured.bytes},
          {"kernels", kernels}};
}

nlohmann::ordered_json to_json(const StepResult& s) {
  return {{"name", s.name},
          {"dimension", s.dimension},
          {"basis", s.basis},
          {"particles", s.particles},
          {"threads", s.threads},
          {"steps", s.steps},
          {"ns_per_particle", s.ns},
          {"least_ns_per_particle", s.least_ns},
          {"newton_per_step", s.newton},
          {"linear_per_step", s.linear},
          {"solver", s.solver},
          {"ms",
           {{"to_grid", s.ms.transfer},
            {"conditions", s.ms.assemble},
            {"solve", s.ms.linear_solve},
            {"to_particles", s.ms.update},
            {"sort", s.ms.sort},
            {"diagnostics", s.ms.diagnostics},
            {"total", s.ms.total}}}};
}

}  // namespace pf::bench
