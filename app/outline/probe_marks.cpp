#include "app/outline/probe_marks.hpp"

#include "core/charts/theme.hpp"

namespace pf::app {

void draw_probes(Painter& painter, const ViewMap& map, const AppContext& context) {
  const bool chosen = context.selected_item && context.selected_item->kind == ItemKind::probe;
  if (!context.snapshot || !(chosen || context.tool == "probe")) return;
  const ChartTheme theme = context.view.theme == Theme::dark ? dark_theme() : light_theme();
  const float em = map.em();
  for (const ProbeReading& reading : context.snapshot->probes) {
    if (reading.probe >= context.scene.probes.size()) continue;
    const auto at = map.to_pixel(reading.x);
    if (!at) continue;
    const bool selected = chosen && context.selected_item->index == reading.probe;
    if (selected) painter.ring(*at, 0.72F * em, theme.text, 0.1F * em);
    painter.circle(*at, 0.5F * em, {0, 0, 0, 0.75F});
    painter.circle(*at, 0.4F * em, {1, 1, 1, 1});
    painter.circle(*at, 0.3F * em, theme.series[reading.probe % theme.series.size()]);
    // A plate behind the name: it may stand on any colour.
    const std::string& name = context.scene.probes[reading.probe].name;
    const float size = 0.95F * em, wide = painter.text_width(name, size);
    const Point2 left{at->x + 0.85F * em, at->y};
    painter.rectangle({left.x - 0.25F * em, left.y - 0.62F * em}, {left.x + wide + 0.25F * em, left.y + 0.62F * em},
                      {0, 0, 0, 0.6F}, 0.2F * em);
    painter.text({left.x, left.y + 0.35F * size}, name, size, {1, 1, 1, 1});
  }
}

}  // namespace pf::app
