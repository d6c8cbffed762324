#include "core/output/summary.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <thread>

#include "core/build_info.hpp"
#include "core/files.hpp"
#include "core/scene/scene_io.hpp"
#include "core/work_weights.hpp"

namespace pf {

namespace {

using nlohmann::ordered_json;

// Value of "name : value" in a file of the proc filesystem; "" when there is none.
std::string proc_value(const char* file, const std::string& name) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(name)) continue;
    const auto colon = line.find(':');
    const auto begin = line.find_first_not_of(" \t", colon + 1);
    if (colon != std::string::npos && begin != std::string::npos) return line.substr(begin);
  }
  return "";
}

ordered_json components(const Vec3& vector, int dimension) {
  ordered_json array = ordered_json::array();
  for (int a = 0; a < dimension; ++a) array.push_back(vector[a]);
  return array;
}

ordered_json state(const StepReport& report, int dimension) {
  const Balance& balance = report.balance;
  ordered_json text{{"step", report.step},
                    {"time", report.time},
                    {"kinetic_energy", balance.kinetic},
                    {"elastic_energy", balance.elastic},
                    {"potential_energy", balance.potential},
                    {"total_energy", balance.total()},
                    {"momentum", components(balance.momentum, dimension)}};
  if (dimension == 3)
    text["angular_momentum"] = components(balance.angular_momentum, 3);
  else
    text["angular_momentum"] = balance.angular_momentum.z();
  text["min_J"] = report.min_J;
  text["max_J"] = report.max_J;
  return text;
}

ordered_json phases(const PhaseTimes& ms) {
  return {{"sort", ms.sort},
          {"transfer", ms.transfer},
          {"assemble", ms.assemble},
          {"linear_solve", ms.linear_solve},
          {"line_search", ms.line_search},
          {"update", ms.update},
          {"diagnostics", ms.diagnostics},
          {"total", ms.total}};
}

ordered_json visits(const Work& work) {
  ordered_json json;
  for (const KernelWeight& kernel : kernel_weights()) json[std::string(kernel.kernel)] = work.*kernel.visits;
  return json;
}

const char* name(RunEnd end) {
  switch (end) {
    case RunEnd::done:
      return "done";
    case RunEnd::interrupted:
      return "interrupted";
    case RunEnd::failed:
      return "failed";
  }
  return "";
}

ordered_json host() {
  const BuildInfo build = build_info();
  return {{"version", build.version},   {"commit", build.commit},
          {"compiler", build.compiler}, {"flags", build.flags},
          {"cpu", processor_name()},    {"hardware_threads", std::thread::hardware_concurrency()}};
}

}  // namespace

std::uint64_t peak_memory() {
  return std::strtoull(proc_value("/proc/self/status", "VmHWM").c_str(), nullptr, 10) * 1024;
}

std::string processor_name() {
  return proc_value("/proc/cpuinfo", "model name");
}

void RunTotals::add(const StepReport& report) {
  ++steps;
  newton_iterations += static_cast<long>(report.newton.size());
  linear_iterations += report.linear_iterations;
  retries += report.retries;
  for (const auto phase : {&PhaseTimes::sort, &PhaseTimes::transfer, &PhaseTimes::assemble, &PhaseTimes::linear_solve,
                           &PhaseTimes::line_search, &PhaseTimes::update, &PhaseTimes::diagnostics, &PhaseTimes::total})
    ms.*phase += report.ms.*phase;
  work += report.work;
  min_J = std::min(min_J, report.min_J);
  max_J = std::max(max_J, report.max_J);
  for (const std::string& warning : report.warnings) ++warnings[warning];
}

SummaryWriter::SummaryWriter(std::filesystem::path file, Scene scene, int threads)
    : file_(std::move(file)), scene_(std::move(scene)), threads_(threads) {}

void SummaryWriter::on_state(const Simulation& simulation) {
  if (begun_) {
    totals_.add(simulation.report());
    return;
  }
  begun_ = true;
  first_step_ = simulation.report().step;
  for (const std::string& warning : simulation.report().warnings) ++totals_.warnings[warning];
}

void SummaryWriter::on_end(const Simulation& simulation, const RunResult& result) {
  wall_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  if (!file_.empty()) write_atomically(file_, document(simulation, result).dump(2) + '\n');
}

ordered_json SummaryWriter::document(const Simulation& simulation, const RunResult& result) const {
  ordered_json text{{"format", "pushforward/summary"}, {"status", name(result.end)}};
  if (result.end == RunEnd::failed) text["failure"] = result.last_attempt.failure;
  text["particles"] = simulation.particle_count();
  text["mass"] = simulation.mass();
  text["first_step"] = first_step_;
  text["totals"] = {{"steps", totals_.steps},
                    {"newton_iterations", totals_.newton_iterations},
                    {"linear_iterations", totals_.linear_iterations},
                    {"retries", totals_.retries},
                    {"particle_visits", visits(totals_.work)},
                    {"min_J", totals_.min_J},
                    {"max_J", totals_.max_J}};
  text["wall_s"] = wall_;
  text["wall_ms_by_phase"] = phases(totals_.ms);
  text["peak_memory_bytes"] = peak_memory();
  const StepReport& report = simulation.report();
  text["final"] = state(report, scene_.dimension);
  if (report.error.known)
    text["final_errors"] = {{"error_l2", report.error.l2},
                            {"error_max", report.error.max},
                            {"error_velocity_l2", report.error.velocity_l2},
                            {"error_F_l2", report.error.F_l2}};
  if (const StrokeSums& strokes = report.strokes; strokes.count > 0)
    text["strokes"] = {{"count", strokes.count},
                       {"cut_particles", strokes.cut},
                       {"painted_particles", strokes.painted},
                       {"removed_mass", strokes.mass},
                       {"removed_energy", strokes.energy},
                       {"removed_momentum", components(strokes.momentum, scene_.dimension)}};
  text["warnings"] = ordered_json::array();
  for (const auto& [warning, count] : totals_.warnings)
    text["warnings"].push_back({{"text", warning}, {"count", count}});
  text["solver"] = simulation.solver_choice();
  text["threads"] = threads_;
  text["seed"] = ordered_json::object();
  for (const Body& body : scene_.bodies) text["seed"][body.name] = body.seed;
  text.update(host());
  text["scene_hash"] = scene_hash(scene_);
  text["scene"] = to_json(scene_);
  return text;
}

std::string SummaryWriter::line(const Simulation& simulation, const RunResult& result) const {
  std::ostringstream out;
  out << (scene_.name.empty() ? "scene" : scene_.name) << ": " << name(result.end) << " at t = " << simulation.time()
      << " s after " << totals_.steps << " steps of " << simulation.particle_count() << " particles in ";
  char wall[32];
  std::snprintf(wall, sizeof wall, "%.3g s", wall_);
  out << wall << " (" << totals_.newton_iterations << " Newton, " << totals_.linear_iterations << " linear iterations)";
  const ErrorNorms& error = simulation.report().error;
  if (error.known) out << ", error_l2 " << error.l2 << " m";
  return out.str();
}

}  // namespace pf
