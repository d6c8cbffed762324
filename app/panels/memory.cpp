#include "app/panels/memory.hpp"

#include <imgui.h>

#include "core/params/setting.hpp"
#include "core/scene/scene_io.hpp"

namespace pf::app {

namespace {

/// The edited scene, but with what only a reset applies as the run was built: the settings behind its curves.
nlohmann::ordered_json as_run(const PanelMemory& m) {
  nlohmann::ordered_json scene = m.json;
  const nlohmann::ordered_json now = m.json.flatten();
  for (const auto& [pointer, value] : now.items()) {
    const Setting* setting = find_setting(pointer);
    const nlohmann::ordered_json::json_pointer at(pointer);
    if (setting != nullptr && setting->applies == Applies::reset && m.running.contains(at))
      scene[at] = m.running.at(at);
  }
  return scene;
}

void follow_pins(AppContext& context, PanelMemory& m) {
  auto& pinned = m.plots.pinned;
  if (pinned.size() > context.pinned.size()) pinned.resize(context.pinned.size());
  while (pinned.size() < context.pinned.size()) {
    const RunHistory& run = context.pinned[context.pinned.size() - 1 - pinned.size()];
    pinned.insert(pinned.begin(), PinnedRun{as_run(m), {}});  // the newest stands first
    pinned.front().curves.follow(run.reports);
  }
  if (pinned.empty()) {
    context.current.label.clear();
    return;
  }
  const nlohmann::ordered_json current = as_run(m);
  std::vector<const nlohmann::ordered_json*> scenes;
  scenes.reserve(pinned.size() + 1);
  for (const PinnedRun& run : pinned) scenes.push_back(&run.scene);
  scenes.push_back(&current);
  const std::vector<std::string> labels = distinguishing_labels(scenes);
  for (std::size_t i = 0; i < pinned.size(); ++i) context.pinned[i].label = labels[i];
  context.current.label = labels.back();
}

}  // namespace

PanelMemory& memory(AppContext& context) {
  if (!context.memory) context.memory = std::make_shared<PanelMemory>();
  PanelMemory& m = *context.memory;
  const int frame = ImGui::GetFrameCount();
  if (m.filled && m.frame == frame) return m;
  m.frame = frame;
  const bool edited = !m.filled || !(m.scene == context.scene);
  if (edited) {
    m.scene = context.scene;
    m.json = to_json(context.scene);
  }
  if (!m.filled || (!context.unsaved && (edited || m.unsaved))) m.opened = m.json;
  m.unsaved = context.unsaved;
  const bool fresh_run = m.run != context.status.run;
  if (!m.filled || fresh_run) m.running = m.json;
  m.run = context.status.run;
  m.filled = true;
  m.plots.current.follow(context.current.reports);
  if (edited || fresh_run || m.plots.relabel || m.plots.pinned.size() != context.pinned.size()) follow_pins(context, m);
  m.plots.relabel = false;
  return m;
}

}  // namespace pf::app
