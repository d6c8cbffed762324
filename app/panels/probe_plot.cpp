// Probes over time: one quantity, a curve for each.
#include <imgui.h>

#include <Eigen/LU>
#include <array>

#include "app/outline/items.hpp"
#include "app/panels/memory.hpp"
#include "app/panels/panels.hpp"
#include "app/panels/series.hpp"
#include "app/widgets/plot.hpp"
#include "app/widgets/run_list.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"
#include "core/diagnostics/stress.hpp"

namespace pf::app {

namespace {

struct Quantity {
  const char* name;
  const char* unit;
  double (*of)(const ProbeReading&);
  bool only_3d = false;
};
using R = const ProbeReading&;
// clang-format off
constexpr std::array quantities{
    Quantity{"Displacement", "m", [](R r) { return (r.x - r.X).norm(); }},
    Quantity{"Displacement x", "m", [](R r) { return r.x.x() - r.X.x(); }},
    Quantity{"Displacement y", "m", [](R r) { return r.x.y() - r.X.y(); }},
    Quantity{"Displacement z", "m", [](R r) { return r.x.z() - r.X.z(); }, true},
    Quantity{"Speed", "m/s", [](R r) { return r.v.norm(); }},
    Quantity{"Velocity x", "m/s", [](R r) { return r.v.x(); }},
    Quantity{"Velocity y", "m/s", [](R r) { return r.v.y(); }},
    Quantity{"Velocity z", "m/s", [](R r) { return r.v.z(); }, true},
    Quantity{"Volume ratio J", "", [](R r) { return r.F.determinant(); }},
    Quantity{"von Mises stress", "Pa", [](R r) { return von_mises(r.sigma); }},
    Quantity{"Pressure", "Pa", [](R r) { return pressure(r.sigma); }},
    Quantity{"Stress xx", "Pa", [](R r) { return r.sigma(0, 0); }},
    Quantity{"Stress yy", "Pa", [](R r) { return r.sigma(1, 1); }},
    Quantity{"Stress zz", "Pa", [](R r) { return r.sigma(2, 2); }},
    Quantity{"Stress xy", "Pa", [](R r) { return r.sigma(0, 1); }},
    Quantity{"Stress yz", "Pa", [](R r) { return r.sigma(1, 2); }, true},
    Quantity{"Stress xz", "Pa", [](R r) { return r.sigma(0, 2); }, true}};
// clang-format on

struct Curve {
  std::vector<double> time, value;
};

std::vector<Curve> curves_of(const AppContext& context, const Quantity& quantity) {
  std::vector<Curve> curves(context.scene.probes.size());
  const auto& reports = context.current.reports;
  for (std::size_t k = 0; k < reports.size() && k < context.current.probes.size(); ++k)
    for (const ProbeReading& reading : context.current.probes[k]) {
      if (reading.probe >= curves.size()) continue;
      curves[reading.probe].time.push_back(reports[k].time);
      curves[reading.probe].value.push_back(quantity.of(reading));
    }
  return curves;
}

void choose(AppContext& context, std::size_t& chosen) {
  ImGui::SetNextItemWidth(-FLT_MIN);
  if (!ImGui::BeginCombo("##quantity", quantities[chosen].name, ImGuiComboFlags_HeightLarge)) return;
  for (std::size_t k = 0; k < quantities.size(); ++k)
    if ((context.scene.dimension == 3 || !quantities[k].only_3d) &&
        ImGui::Selectable(quantities[k].name, k == chosen)) {
      chosen = k;
      memory(context).plots.probe_view = {};
    }
  ImGui::EndCombo();
}

void draw_list(AppContext& context, const std::vector<Curve>& curves, const Quantity& quantity) {
  std::optional<std::size_t> gone;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const SceneItem item{ItemKind::probe, k};
    ImGui::PushID(static_cast<int>(k));
    legend_entry(context, k, context.scene.probes[k].name, newest(curves[k].value, quantity.unit));
    if (ImGui::IsItemClicked()) context.selected_item = item;
    if (context.selected_item == item && text_button("Delete this probe")) gone = k;
    ImGui::PopID();
  }
  if (gone && edit_scene(context, deleted(context.scene, {ItemKind::probe, *gone}))) context.selected_item.reset();
}

}  // namespace

void draw_probe_plot(AppContext& context) {
  PlotMemory& m = memory(context).plots;
  if (quantities[m.probe_quantity].only_3d && context.scene.dimension == 2) m.probe_quantity = 0;
  const Quantity& quantity = quantities[m.probe_quantity];
  const std::vector<Curve> curves = curves_of(context, quantity);
  if (begin_run_list()) {
    choose(context, m.probe_quantity);
    draw_list(context, curves, quantity);
    end_run_list();
  }
  Chart chart = time_chart(quantity.name, quantity.unit);
  for (std::size_t k = 0; k < curves.size() && k < context.scene.probes.size(); ++k)
    add_series(chart, context.scene.probes[k].name, curves[k].time, curves[k].value, k, Role::current);
  plot(context, "probes", std::move(chart), m.probe_view);
}

}  // namespace pf::app
