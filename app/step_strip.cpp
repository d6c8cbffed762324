#include "app/step_strip.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/imgui_painter.hpp"
#include "app/theme.hpp"
#include "app/widgets/units.hpp"
#include "core/charts/theme.hpp"

namespace pf::app {

namespace {

/// What one column of pixels has to show.
struct Column {
  double shortest = 0, longest = 0;  ///< dt [s]; 0: no step
  bool implicit = false, given_up = false;
};

bool chosen(const StepReport& report) {
  return report.control.adaptive && report.dt > 0;
}

Color colour_of(const AppContext& context, bool implicit) {
  const ChartTheme theme = context.view.theme == Theme::dark ? dark_theme(1) : light_theme(1);
  return theme.series[implicit ? 0 : 1];
}

std::vector<Column> columns_of(const std::vector<StepReport>& reports, double end, float width) {
  std::vector<Column> columns(static_cast<std::size_t>(std::max(1.0f, width)));
  const auto last = static_cast<double>(columns.size()) - 1;
  for (const StepReport& report : reports) {
    if (!chosen(report)) continue;
    const double scale = static_cast<double>(columns.size()) / end;
    const auto from = static_cast<std::size_t>(std::clamp((report.time - report.dt) * scale, 0.0, last));
    const auto to = static_cast<std::size_t>(std::clamp(report.time * scale, 0.0, last));
    for (std::size_t k = from; k <= to; ++k) {
      Column& c = columns[k];
      c.shortest = c.shortest > 0 ? std::min(c.shortest, report.dt) : report.dt;
      c.longest = std::max(c.longest, report.dt);
      c.implicit = report.control.implicit;
      c.given_up = c.given_up || report.control.given_up > 0 || report.retries > 0;
    }
  }
  return columns;
}

void draw_columns(const AppContext& context, const std::vector<Column>& columns, const Rect& place) {
  double low = 1e300, high = 0;
  for (const Column& c : columns)
    if (c.longest > 0) low = std::min(low, c.shortest), high = std::max(high, c.longest);
  // A decade at least, so that equal steps are one calm line.
  low = std::min(low, high / 10);
  ImGuiPainter painter(*ImGui::GetWindowDrawList());
  const auto y_of = [&](double dt) {
    const double part = std::log(dt / low) / std::log(high / low);
    return place.bottom() - 2 - static_cast<float>(part) * (place.height - 4);
  };
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const Column& c = columns[k];
    if (!(c.longest > 0)) continue;
    const float x = place.x + static_cast<float>(k);
    Color color = colour_of(context, c.implicit);
    painter.rectangle({x, y_of(c.longest)}, {x + 1, std::max(y_of(c.shortest), y_of(c.longest) + 2)}, color);
    color.a *= 0.25f;
    painter.rectangle({x, y_of(c.longest)}, {x + 1, place.bottom()}, color);
    if (c.given_up) painter.rectangle({x, place.y}, {x + 1, place.y + 3}, palette(context.view.theme).error);
  }
}

/// "31 % less work" of the chosen kind against the other.
std::string comparison(const ControlReport& control) {
  if (!(control.explicit_cost > 0) || !(control.implicit_cost > 0)) return "";
  const double mine = control.implicit ? control.implicit_cost : control.explicit_cost;
  const double other = control.implicit ? control.explicit_cost : control.implicit_cost;
  return std::string(control.implicit ? "Explicit" : "Implicit") + " steps: " + quantity(other / mine, "", 2) +
         " times the work";
}

void tell_step(const AppContext& context, const StepReport& report) {
  const ControlReport& control = report.control;
  std::string text = "t = " + quantity(report.time, "s", 4) + ", step " + std::to_string(report.step) + "\n" +
                     (control.implicit ? "Implicit" : "Explicit") + ", dt = " + quantity(report.dt, "s", 3) + ": " +
                     reason_of(control.limited_by) + "\nEstimated error " + quantity(control.error_rate, "", 2) +
                     " a second, tolerance " +
                     quantity(context.scene.time.tolerance.value_or(default_tolerance), "", 3);
  if (const std::string costs = comparison(control); !costs.empty()) text += "\n" + costs;
  if (control.given_up > 0)
    text += "\n" + std::to_string(control.given_up) +
            (control.given_up == 1 ? " longer step was" : " longer steps were") + " given up as too inexact";
  ImGui::SetTooltip("%s", text.c_str());
}

/// Colour, kind and length of the newest step; returns its width.
float draw_newest(const AppContext& context, const Rect& place) {
  const std::vector<StepReport>& reports = context.current.reports;
  const float em = ImGui::GetFontSize(), side = 0.6f * em;
  if (reports.empty() || !chosen(reports.back())) return 0;
  const StepReport& newest = reports.back();
  const std::string text = (newest.control.implicit ? "Implicit, " : "Explicit, ") + quantity(newest.dt, "s", 3) +
                           ": " + name_of(newest.control.limited_by);
  ImGuiPainter painter(*ImGui::GetWindowDrawList());
  const float middle = place.y + place.height / 2;
  painter.rectangle({place.x, middle - side / 2}, {place.x + side, middle + side / 2},
                    colour_of(context, newest.control.implicit));
  const float size = small_font()->FontSize;
  painter.text({place.x + 1.5f * side, middle + 0.36f * size}, text, size, palette(context.view.theme).muted);
  return 16 * em;
}

}  // namespace

const char* reason_of(StepLimit limit) {
  switch (limit) {
    case StepLimit::fixed:
      return "the time step";
    case StepLimit::tolerance:
      return "as long as the tolerance lets it be";
    case StepLimit::stability:
      return "a longer one would not be stable";
    case StepLimit::newton:
      return "a longer one would cost Newton's method too much";
    case StepLimit::crossing:
      return "no particle shall cross more than a cell";
    case StepLimit::largest:
      return "as long as the time step lets it be";
    case StepLimit::growth:
      return "growing after a shorter one";
    case StepLimit::landing:
      return "to land on the end";
    case StepLimit::failure:
      return "a longer one did not work out";
  }
  return "";
}

bool has_step_strip(const AppContext& context) {
  return context.scene.time.control == "adaptive";
}

void draw_step_strip(const AppContext& context, const Rect& place) {
  const std::vector<StepReport>& reports = context.current.reports;
  const float em = ImGui::GetFontSize();
  ImGui::SetCursorScreenPos({place.x, place.y});
  ImGui::InvisibleButton("step-strip", {place.width, place.height});
  const bool hovered = ImGui::IsItemHovered();
  const float label = std::min(draw_newest(context, place), 0.4f * place.width);
  const Rect strip{place.x + label, place.y, place.width - label, place.height - 0.3f * em};
  const double end = std::max(context.scene.time.end, reports.empty() ? 0.0 : reports.back().time);
  draw_columns(context, columns_of(reports, end, strip.width), strip);
  const float mouse = ImGui::GetIO().MousePos.x;
  if (!hovered || mouse < strip.x) return;
  const double time = static_cast<double>((mouse - strip.x) / strip.width) * end;
  const auto step =
      std::lower_bound(reports.begin(), reports.end(), time, [](const StepReport& r, double t) { return r.time < t; });
  if (step != reports.end() && chosen(*step)) tell_step(context, *step);
}

}  // namespace pf::app
