#include "tests/panels/harness.hpp"

#include <cmath>

#include "core/scene/scene_io.hpp"

namespace pf::app {

Scene rich_scene() {
  return parse_scene(R"({
    "name": "Two blocks on a rough floor", "about": "A soft block and a stiff one fall on a floor that rubs.",
    "dimension": 2, "gravity": [0, -9.81], "grid": { "spacing": 0.05 },
    "time": { "end": 2, "step": 0.01 }, "transfer": { "type": "flip" },
    "materials": { "soft": { "model": "neo_hookean", "density": 1000, "young": 1e5, "poisson": 0.3 },
                   "stiff": { "model": "hencky", "density": 2700, "young": 7e10, "poisson": 0.33 } },
    "bodies": [
      { "name": "block", "material": "soft", "shape": { "type": "box", "min": [0.2, 0.5], "max": [0.6, 0.9] } },
      { "name": "anvil", "material": "stiff", "velocity": ["0", "-1-0.5*X"],
        "shape": { "type": "ball", "center": [1, 0.6], "radius": 0.2 } } ],
    "boundaries": [ { "shape": { "type": "half_space", "point": [0, 0.1], "normal": [0, 1] }, "friction": 0.4 } ],
    "probes": [ { "name": "top", "at": [0.4, 0.9] }, { "name": "anvil", "at": [1, 0.6] } ]
  })",
                     "rich scene");
}

Scene plain_scene() {
  return parse_scene(R"({
    "name": "A ball", "dimension": 3, "grid": { "spacing": 0.1 }, "transfer": { "type": "apic" },
    "materials": { "gum": { "model": "fixed_corotated", "density": 1000, "young": 1e4, "poisson": 0.4 } },
    "bodies": [ { "material": "gum", "shape": { "type": "ball", "center": [0, 0, 0], "radius": 0.5 } } ]
  })",
                     "plain scene");
}

std::vector<StepReport> made_up_reports(int steps) {
  std::vector<StepReport> reports;
  for (int k = 0; k <= steps; ++k) {
    StepReport r;
    r.step = k;
    r.time = 0.01 * k;
    r.dt = 0.01;
    const double swing = std::cos(12 * r.time) * std::exp(-r.time), fade = std::exp(-r.time);
    r.balance.kinetic = 120 * swing * swing;
    r.balance.elastic = 80 * (1 - swing * swing) * fade;
    r.balance.potential = 40 * fade * fade;
    r.balance.momentum = Vec3(3 * swing, -2 * swing, 0);
    r.balance.angular_momentum = Vec3(0, 0, 0.8 * fade);
    r.angular.transfer = Vec3(0, 0, -0.005 * fade);
    r.angular.time_integration = Vec3(0, 0, -0.003 * fade);
    r.angular.outside = Vec3(0, 0, 0.002 * swing);
    for (int i = 0; k > 0 && i < 4; ++i)
      r.newton.push_back(
          {std::pow(10.0, -1.5 * i), 1 - 0.1 * i, i == 0 ? 0.5 : 1.0, 12 + 3 * i, i == 1 ? 0.25 : 0, false});
    r.residual = k > 0 ? 3e-7 : 0;
    r.linear_iterations = 66;
    r.ms = {0.2, 0.7, 0.1, 4.2 + 0.5 * swing, 0.9, 0.4, 0.3, 6.8 + 0.5 * swing};
    r.active_nodes = 800;
    reports.push_back(r);
  }
  return reports;
}

namespace {

/// No scene is opened here: the panels are drawn from what the harness puts into the context.
std::unique_ptr<Simulation> no_simulation(const Scene&, const SimulationOptions&) {
  return nullptr;
}

}  // namespace

void fill(AppContext& context, const Scene& scene) {
  context.scene = scene;
  context.status.state = RunState::running;
  context.status.run = 1;
  context.status.solver_choice = "direct: 1612 unknowns";
  context.current.reports = made_up_reports(60);
  context.current.probes.clear();
  for (const StepReport& report : context.current.reports) {
    auto& readings = context.current.probes.emplace_back();
    for (std::size_t k = 0; k < scene.probes.size(); ++k) {
      ProbeReading reading;
      reading.probe = k;
      reading.x = Vec3(report.time, static_cast<double>(k), 0);
      readings.push_back(reading);
    }
  }
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->dimension = scene.dimension;
  snapshot->spacing = scene.grid.spacing;
  snapshot->particles = 12345;
  snapshot->report = context.current.reports.back();
  context.snapshot = snapshot;
  context.change = [&context](const std::vector<Edit>& edits) {
    try {
      context.scene = edited(context.scene, edits);
    } catch (const InputError& error) {
      context.problems = error.problems();
      return false;
    }
    context.unsaved = true;
    return true;
  };
  context.open_file = [](const std::filesystem::path&) {};
  context.pin = [&context] { context.pinned.push_front(context.current); };
}

Harness::Harness(const Scene& scene, Theme theme, float scale) : session(1, no_simulation), context(session) {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  build_fonts(scale);
  apply_theme(theme, scale);
  fill(context, scene);
  context.view.theme = theme;
}

Harness::~Harness() {
  ImGui::DestroyContext();
}

std::vector<Letter> Harness::frame(ImVec2 size, const std::function<void(AppContext&)>& draw) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = size;
  io.DeltaTime = 1.0F / 60;
  ImGui::NewFrame();
  ImGui::SetNextWindowPos(ImVec2(0, 0));
  ImGui::SetNextWindowSize(size);
  ImGui::Begin("dock", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
  draw(context);
  ImGui::End();
  ImGui::Render();
  return letters(*ImGui::GetDrawData());
}

std::vector<Letter> Harness::settle(ImVec2 size, const std::function<void(AppContext&)>& draw) {
  for (int i = 0; i < 3; ++i) frame(size, draw);
  return frame(size, draw);
}

}  // namespace pf::app
