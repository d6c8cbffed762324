#include "app/time_line.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/imgui_painter.hpp"
#include "app/theme.hpp"
#include "app/widgets/units.hpp"

namespace pf::app {
namespace {

/// What the whole line stands for [s].
double end_of(const AppContext& context) {
  const auto& reports = context.current.reports;
  return std::max({context.scene.time.end, reports.empty() ? 0.0 : reports.back().time, 1e-300});
}

/// The report of the state nearest to `time`, or nullptr.
const StepReport* nearest(const AppContext& context, double time) {
  const auto& reports = context.current.reports;
  if (reports.empty()) return nullptr;
  auto at =
      std::lower_bound(reports.begin(), reports.end(), time, [](const StepReport& r, double t) { return r.time < t; });
  if (at == reports.end()) return &reports.back();
  if (at != reports.begin() && time - std::prev(at)->time < at->time - time) --at;
  return &*at;
}

const StepReport* report_of(const AppContext& context, long step) {
  const auto& reports = context.current.reports;
  if (reports.empty() || step < reports.front().step || step > reports.back().step) return nullptr;
  return &reports[static_cast<std::size_t>(step - reports.front().step)];
}

Color with_alpha(Color color, float alpha) {
  color.a *= alpha;
  return color;
}

}  // namespace

void TimeLine::follow(const AppContext& context) {
  const auto& reports = context.current.reports;
  const SessionStatus& s = context.status;
  if (s.run != run_ || s.branches != branches_ || reports.size() < seen_) {
    seen_ = 0;
    bad_.clear();
  }
  if (s.run != run_ || s.branches != branches_ || s.edit.edit != edit_ ||
      (context.snapshot && context.snapshot->grabbed))
    edits_ = context.session.edit_times();
  run_ = s.run;
  branches_ = s.branches;
  edit_ = s.edit.applies_at_step < 0 ? s.edit.edit : 0;  // one that waits is not recorded yet
  constexpr std::size_t enough = 16;
  for (; seen_ < reports.size(); ++seen_) {
    const std::size_t first = seen_ + 1 > enough ? seen_ + 1 - enough : 0;
    const std::span<const StepReport> recent(reports.data() + first, seen_ + 1 - first);
    if (auto bad = bad_step(recent, context.scene.solver.newton_tolerance)) bad_.push_back(std::move(*bad));
  }
}

std::vector<BadStep> TimeLine::all_bad(const AppContext& context) const {
  std::vector<BadStep> all = bad_;
  const SessionStatus& s = context.status;
  if (s.state == RunState::failed && (all.empty() || all.back().step < s.reached))
    all.push_back({s.reached, "The run cannot go on from here. " + s.message});
  return all;
}

bool TimeLine::any_bad(const AppContext& context) const {
  return !bad_.empty() || context.status.state == RunState::failed;
}

std::optional<BadStep> TimeLine::next_bad(const AppContext& context) const {
  const std::vector<BadStep> all = all_bad(context);
  if (all.empty()) return std::nullopt;
  const long now = wanted_step(context.status);
  const auto next = std::find_if(all.begin(), all.end(), [&](const BadStep& b) { return b.step > now; });
  return now >= context.status.reached || next == all.end() ? all.front() : *next;
}

void TimeLine::tell(const AppContext& context, double time) const {
  const StepReport* report = nearest(context, time);
  if (!report) return;
  const double reached = context.current.reports.back().time, tolerance = 0.006 * end_of(context);
  std::string text;
  if (time > reached + tolerance) {
    text = "Not simulated yet";
  } else {
    text = "t = " + quantity(report->time, "s", 4) + ", step " + std::to_string(report->step);
    for (const double edit : edits_)
      if (std::abs(edit - time) < tolerance) {
        text += "\nHere the scene was edited or pulled at";
        break;
      }
    for (const BadStep& bad : all_bad(context))
      if (const StepReport* r = report_of(context, bad.step); r && std::abs(r->time - time) < tolerance) {
        text += "\nStep " + std::to_string(bad.step) + ": " + bad.why;
        break;
      }
    text += "\nClick or drag to go there";
  }
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(26 * ImGui::GetFontSize());
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void TimeLine::draw_marks(const AppContext& context, const Rect& line, double end) {
  ImGuiPainter painter(*ImGui::GetWindowDrawList());
  const float em = ImGui::GetFontSize();
  const Palette& colors = palette(context.view.theme);
  const auto x_of = [&](double time) {
    return line.x + static_cast<float>(std::clamp(time / end, 0.0, 1.0)) * line.width;
  };
  float last = -1e9F;
  for (const double time : edits_) {
    const float x = x_of(time), y = line.bottom() + 0.12F * em, r = 0.22F * em;
    if (x < last + 0.5F * r) continue;  // a dragged slider is one mark after the other
    last = x;
    painter.polygon(std::vector<Point2>{{x, y}, {x + r, y + 1.5F * r}, {x - r, y + 1.5F * r}}, colors.text);
  }
  for (const BadStep& bad : all_bad(context))
    if (const StepReport* report = report_of(context, bad.step)) {
      const float x = x_of(report->time);
      painter.rectangle({x - 0.08F * em, line.y - 0.32F * em}, {x + 0.08F * em, line.bottom()}, colors.warning);
    }
}

void TimeLine::draw(AppContext& context, const Rect& place) {
  follow(context);
  const float em = ImGui::GetFontSize();
  ImGui::SetCursorScreenPos({place.x, place.y});
  ImGui::InvisibleButton("time-line", {std::max(1.0F, place.width), std::max(1.0F, place.height)});
  const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
  const float middle = place.y + 0.52F * place.height, thick = (hovered || active ? 0.34F : 0.26F) * em;
  const Rect line{place.x, middle - thick / 2, place.width, thick};
  const auto& reports = context.current.reports;
  const SessionStatus& s = context.status;
  const double end = end_of(context);
  const auto x_of = [&](double time) {
    return line.x + static_cast<float>(std::clamp(time / end, 0.0, 1.0)) * line.width;
  };
  const Palette& colors = palette(context.view.theme);
  ImGuiPainter painter(*ImGui::GetWindowDrawList());
  painter.rectangle({line.x, line.y}, {line.right(), line.bottom()}, with_alpha(colors.muted, 0.3F), thick / 2);
  if (s.state == RunState::loading || reports.empty()) return;
  const StepReport* wanted = s.target >= 0 ? report_of(context, s.target) : nullptr;
  const double now = active && wanted ? wanted->time : s.time;
  const float reached = x_of(reports.back().time), here = x_of(now);
  painter.rectangle({line.x, line.y}, {reached, line.bottom()}, with_alpha(colors.accent, 0.35F), thick / 2);
  painter.rectangle({line.x, line.y}, {here, line.bottom()}, colors.accent, thick / 2);
  draw_marks(context, line, end);
  painter.circle({here, middle}, (hovered || active ? 0.42F : 0.34F) * em, colors.accent);
  painter.circle({here, middle}, (hovered || active ? 0.18F : 0.12F) * em, colors.bar);
  const double under = static_cast<double>((ImGui::GetIO().MousePos.x - line.x) / line.width) * end;
  if (active) {
    const StepReport* to = nearest(context, std::clamp(under, 0.0, end));
    if (to && to->step != sent_ && (to->step != wanted_step(s) || s.state == RunState::running))
      context.session.go_to(sent_ = to->step);
  } else {
    sent_ = -1;
  }
  if (hovered && !active) tell(context, under);
}

}  // namespace pf::app
