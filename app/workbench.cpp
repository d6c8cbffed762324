#include "app/workbench.hpp"
#include "app/advice/desk.hpp"
#include "app/compare/desk.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "app/inside/step_player.hpp"
#include "app/lessons/desk.hpp"
#include "app/panels/docks.hpp"
#include "app/panels/panels.hpp"
#include "app/step_strip.hpp"
#include "app/theme.hpp"
#include "render/picture.hpp"

namespace pf::app {
namespace {

constexpr auto dock_flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                            ImGuiWindowFlags_NoBringToFrontOnFocus;

constexpr std::size_t solver_history = 200;

constexpr std::chrono::milliseconds longest_rest{100};

/// Where the processor draws, a scene that is being built has it for so long, once the window says that it is.
constexpr std::chrono::milliseconds building_time{150};

/// A part of the window, filled by `content`.
template <typename Content>
void part(const char* name, const Rect& where, ImVec2 padding, int flags, const Content& content) {
  if (where.empty()) return;
  ImGui::SetNextWindowPos({where.x, where.y});
  ImGui::SetNextWindowSize({where.width, where.height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::Begin(name, nullptr, dock_flags | flags);
  ImGui::PopStyleVar(2);
  content();
  ImGui::End();
}

/// A child that shows how far it scrolls. Its bar has its place always, so that tables keep their width, and is to be
/// seen where there is more below.
void begin_reading() {
  ImGuiStorage& kept = *ImGui::GetStateStorage();
  const ImGuiID scrolls = ImGui::GetID("scrolls");
  const bool hidden = !kept.GetBool(scrolls);
  if (hidden)
    for (const ImGuiCol part : {ImGuiCol_ScrollbarGrab, ImGuiCol_ScrollbarGrabHovered, ImGuiCol_ScrollbarGrabActive})
      ImGui::PushStyleColor(part, ImVec4(0, 0, 0, 0));
  ImGui::BeginChild("read", {0, 0}, false, ImGuiWindowFlags_AlwaysVerticalScrollbar);
  if (hidden) ImGui::PopStyleColor(3);
  kept.SetBool(scrolls, ImGui::GetScrollMaxY() > 0);
}

bool same_news(const SessionStatus& a, const SessionStatus& b) {
  return a.state == b.state && a.run == b.run && a.step == b.step && a.step_in_flight == b.step_in_flight &&
         a.reached == b.reached && a.target == b.target && a.edit.edit == b.edit.edit &&
         a.edit.applies_at_step == b.edit.applies_at_step && a.edit.needs_reset == b.edit.needs_reset &&
         a.suspended == b.suspended && a.message == b.message;
}

WindowSize remembered_size(const Preferences& p) {
  return {p.window_width, p.window_height, p.maximized};
}

}  // namespace

Workbench::Workbench(const Scene& scene, const std::filesystem::path& file, const Setup& setup)
    : window_("Pushforward", remembered_size(load_preferences(setup.folders)), setup.visible),
      preferences_(load_preferences(setup.folders)),
      setup_(setup),
      session_(setup.threads),
      context_{session_},
      at_end_(setup.at_end) {
  context_.view.theme = preferences_.theme;
  context_.view.ui_scale = preferences_.ui_scale;
  drawer_open_ = preferences_.drawer_open;
  session_.set_wake([this] {
    news_ = true;
    GlfwWindow::wake();
  });
  session_.set_at_end(at_end_);
  session_.set_rewind_memory(static_cast<std::size_t>(preferences_.rewind_megabytes) << 20);
  set_actions();
  open_scene(scene, file, setup.run);  // the worker builds while fonts and shaders are made
  follow_scale();
  view_ = std::make_unique<GlView>();
}

Workbench::~Workbench() {
  session_.set_wake({});
  keep_preferences();
}

void Workbench::keep_preferences() {
  if (!setup_.remember) return;
  const WindowSize size = window_.size();
  preferences_.window_width = size.width;
  preferences_.window_height = size.height;
  preferences_.maximized = size.maximized;
  preferences_.theme = context_.view.theme;
  preferences_.ui_scale = std::clamp(context_.view.ui_scale, smallest_scale, largest_scale);
  preferences_.drawer_open = drawer_open_;
  try {
    save_preferences(preferences_, setup_.folders);
  } catch (const FileError&) {
    // Nothing of the user's work is lost by it.
  }
}

void Workbench::remember_file(const std::filesystem::path& file) {
  note_recent(preferences_, file);
  keep_preferences();  // now: a program that is killed has no later
}

double Workbench::patience(double longest) const {
  const double held = std::chrono::duration<double>(held_until_ - Clock::now()).count();
  if (settle_ > 0 && held <= 0) return 0;
  double seconds = held > 0 ? std::min(longest, held) : longest;
  if (notices_.any() || context_.status.step_in_flight) seconds = std::min(seconds, 0.2);
  if (context_.slow && context_.slow->playing) seconds = std::min(seconds, 1.0 / 60);
  if (ImGui::GetIO().WantTextInput) seconds = std::min(seconds, 0.25);  // the cursor blinks
  if (view_) seconds = std::min(seconds, view_->refines_in().value_or(seconds));
  if (news_to_show_ && held <= 0)
    seconds = std::clamp(std::chrono::duration<double>(rest_until_ - Clock::now()).count(), 0.0, seconds);
  return seconds;
}

bool Workbench::frame(double longest) {
  try {
    const bool going_on = turn(longest);
    mishaps_ = 0;
    return going_on;
  } catch (const std::exception& error) {
    // Neither the scene nor the run is lost by it; but where not even this can be shown, going on is no use.
    if (++mishaps_ > 3) throw;
    window_.abandon_frame();
    report_trouble("the window", std::string("This went wrong: ") + error.what());
  }
  return true;
}

bool Workbench::turn(double longest) {
  window_.wait(patience(longest));
  if (window_.take_touched()) settle_ = 4;  // press, release, what they open, and its size
  handle_input();
  const bool news = news_.exchange(false);
  const SessionStatus before = context_.status;
  const auto seen = context_.snapshot;
  follow_session();
  record_frame();
  const bool changed = (news && !same_news(before, context_.status)) || seen != context_.snapshot;
  const bool refine = view_ && view_->refines_in() == 0.0;
  const bool playing = context_.slow && context_.slow->playing;
  const bool timed = playing || notices_.expire() || ImGui::GetIO().WantTextInput || refine;
  if (study_news_.exchange(false)) follow_studies();
  news_to_show_ |= changed || !same_news(before, context_.status);
  const bool loading = context_.status.state == RunState::loading;
  if (!loading) held_until_ = {};
  if (!loading && loading_shown_) rest_until_ = {};  // the new picture has been waited for
  if (timed || (news_to_show_ && Clock::now() >= rest_until_)) settle_ = std::max(settle_, 1);
  if (settle_ > 0 && Clock::now() >= held_until_ && !leaving_) {
    --settle_;
    news_to_show_ = false;
    const auto begin = Clock::now();
    draw();
    take_window_picture();
    window_.show();
    // Where the processor draws, the simulation shall have at least half of its time.
    const auto end = Clock::now();
    rest_until_ = view_->software() ? end + std::min<Clock::duration>(end - begin, longest_rest) : end;
    if (view_->software() && loading && !loading_shown_) held_until_ = begin + building_time;
    loading_shown_ = loading;
  }
  return !leaving_;
}

void Workbench::handle_input() {
  for (const auto& key : window_.take_keys()) {
    const auto press = find_key(key.key, key.mods);
    if (!press || (key.repeated && press->action != Action::step)) continue;
    const bool modal = ImGui::GetTopMostPopupModal() != nullptr || file_dialog_.is_open() || scene_picker_.is_open();
    if (!modal && possible(press->action)) act(press->action, press->index);
  }
  for (const auto& file : window_.take_dropped()) {
    open_file(file);
    break;  // one window, one scene
  }
  if (window_.take_focus_lost() && view_) view_->cancel_tool(context_);
  if (window_.take_close_request()) act(Action::quit);
}

void Workbench::follow_session() {
  context_.status = session_.status();
  context_.snapshot = session_.snapshot();  // after the status: at least as new
  context_.record = session_.record();
  follow_slow_step();
  SnapshotRequest wanted = snapshot_request(render_options(context_, 1));
  wanted.stable_step = wants_stable_step(context_);
  wanted.reference = context_.tool == "probe";
  if (wanted.fields != requested_.fields || wanted.grid != requested_.grid || wanted.stress != requested_.stress ||
      wanted.stable_step != requested_.stable_step || wanted.reference != requested_.reference) {
    requested_ = wanted;
    session_.request(wanted);
  }
  follow_comparison();
  if (context_.advice) context_.advice->follow(context_);
  follow_history();
  follow_selection();
  follow_lesson(context_);
}

void Workbench::follow_history() {
  if (context_.status.run != shown_run_ && context_.status.state != RunState::loading) {
    shown_run_ = context_.status.run;
    shown_branches_ = context_.status.branches;
    context_.current = {context_.scene.name, false, {}, {}};
    if (view_) view_->begin_run(context_);
    if (view_ && std::exchange(fit_next_run_, false)) view_->fit();
  }
  follow_branch();
  session_.drain_history(fresh_);
  auto& reports = context_.current.reports;
  const auto later =
      std::stable_partition(fresh_.begin(), fresh_.end(), [&](const HistorySample& s) { return s.run <= shown_run_; });
  for (auto it = fresh_.begin(); it != later; ++it) {
    if (it->run != shown_run_) continue;
    if (it->again) {
      const auto k = static_cast<std::size_t>(it->report.step);
      if (k >= reports.size() || reports[k].step != it->report.step) continue;
      if (it->report.energy.known) reports[k].energy = it->report.energy;
      context_.current.probes[k] = std::move(it->probes);
      continue;
    }
    // Newton's iterations are shown for the newest steps only; a long run need not keep them all.
    if (reports.size() >= solver_history) reports[reports.size() - solver_history].newton = {};
    while (!reports.empty() && reports.back().step >= it->report.step) reports.pop_back();
    context_.current.probes.resize(reports.size());
    context_.current.probes.push_back(std::move(it->probes));
    reports.push_back(std::move(it->report));
  }
  fresh_.erase(fresh_.begin(), later);
  time_line_.follow(context_);
}

void Workbench::follow_branch() {
  if (context_.status.branches == std::exchange(shown_branches_, context_.status.branches)) return;
  auto& reports = context_.current.reports;
  const long reached = context_.status.reached;
  // What would have come stays in sight, in grey behind what comes now.
  constexpr long worth_keeping = 3;
  if (!reports.empty() && reports.back().step >= reached + worth_keeping) pin();
  while (!reports.empty() && reports.back().step > reached) reports.pop_back();
  context_.current.probes.resize(reports.size());
}

void Workbench::follow_scale() {
  context_.view.ui_scale = std::clamp(context_.view.ui_scale, smallest_scale, largest_scale);
  const float scale = window_.content_scale() * context_.view.ui_scale;
  const bool other_scale = std::abs(scale - built_scale_) > 0.01f;
  // While a slider for the scale is held, the window would move away under the mouse.
  const bool busy = built_scale_ > 0 && ImGui::IsAnyMouseDown();
  if (other_scale && !busy) {
    build_fonts(scale);
    window_.renew_fonts();
    built_scale_ = scale;
    settle_ = 3;
  }
  if ((other_scale && !busy) || applied_theme_ != context_.view.theme || frames_ == 0) {
    apply_theme(context_.view.theme, built_scale_);
    applied_theme_ = context_.view.theme;
  }
}

void Workbench::draw() {
  follow_scale();
  window_.begin_frame();
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  LayoutInput in;
  in.width = display.x;
  in.height = display.y;
  in.em = ImGui::GetFontSize();
  in.menu_height = menu_height_ > 0 ? menu_height_ : ImGui::GetFrameHeight();
  in.hide_panels = context_.view.hide_panels;
  in.inspector = has_inspector(context_);
  in.wide_right = has_wide_inspector(context_);
  in.step_strip = has_step_strip(context_) && !context_.slow;
  in.drawer_open = drawer_open_;
  in.drawer_height = preferences_.drawer_height;
  layout_ = arrange(in);
  if (comparing(context_)) {
    draw_lanes();
  } else {
    view_->place(layout_.view, window_.pixels_per_unit(), static_cast<float>(window_.framebuffer_height()),
                 view_margins());
    view_->handle_mouse(context_);
    view_->draw(context_);
  }
  draw_parts();
  watch();
  take_view_picture();
  window_.end_frame();
  ++frames_;
}

Image Workbench::screenshot() {
  draw();
  Image image = window_.read();
  window_.show();
  return image;
}

void Workbench::draw_parts() {
  const float em = ImGui::GetFontSize();
  const ImVec2 usual = ImGui::GetStyle().WindowPadding;
  if (comparing(context_))
    draw_lanes_overlay();
  else
    view_->draw_overlay(context_, *ImGui::GetBackgroundDrawList());
  if (!layout_.menu.empty()) draw_menus();
  part("left", layout_.left, usual, 0, [&] {
    ImGui::BeginChild("settings");
    draw_left_column(context_);
    ImGui::EndChild();
  });
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_MenuBarBg));
  part("transport", layout_.transport, {0.8f * em, 0}, ImGuiWindowFlags_NoScrollWithMouse, [&] { draw_transport(); });
  ImGui::PopStyleColor();
  part("inspector", layout_.inspector, usual, 0, [&] {
    begin_reading();
    draw_inspector(context_);
    ImGui::EndChild();
  });
  context_.wants_record =
      false;  // until a panel of this frame wants it; what lies above shows what the last one wanted
  part("drawer", layout_.drawer, {0.8f * em, 0.25f * em}, ImGuiWindowFlags_NoScrollWithMouse, [&] {
    if (drawer_open_) draw_splitter();
    draw_bottom_drawer(context_);
    draw_drawer_toggle();
  });
  draw_tool_bar();
  draw_failure_banner();
  notices_.draw(layout_.view);
  recorder_.draw_mark(context_, layout_.view, hide_mark_);
  draw_dialogs();
}

void Workbench::draw_drawer_toggle() {
  const float em = ImGui::GetFontSize(), size = ImGui::GetFrameHeight();
  const Rect& drawer = layout_.drawer;
  ImGui::SetCursorScreenPos({drawer.right() - size - 0.8f * em, drawer.y + 0.25f * em});
  bool toggle = ImGui::InvisibleButton("toggle", {size, size});
  const ImU32 color = ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_Text : ImGuiCol_TextDisabled);
  const ImVec2 min = ImGui::GetItemRectMin();
  const float y = drawer_open_ ? 0.15f * em : -0.15f * em;
  const std::array<ImVec2, 3> chevron{ImVec2{min.x + size / 2 - 0.3f * em, min.y + size / 2 - y},
                                      ImVec2{min.x + size / 2, min.y + size / 2 + y},
                                      ImVec2{min.x + size / 2 + 0.3f * em, min.y + size / 2 - y}};
  ImGui::GetWindowDrawList()->AddPolyline(chevron.data(), 3, color, ImDrawFlags_None, 0.12f * em);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip(drawer_open_ ? "Close the plots" : "Open the plots");
  // A click on a closed drawer's tab opens it, too.
  toggle |= !drawer_open_ && ImGui::IsWindowHovered() && ImGui::IsMouseReleased(ImGuiMouseButton_Left);
  if (!toggle) return;
  drawer_open_ = !drawer_open_;
  settle_ = 3;
}

void Workbench::draw_splitter() {
  const float em = ImGui::GetFontSize();
  const ImVec2 cursor = ImGui::GetCursorPos();
  ImGui::SetCursorScreenPos({layout_.drawer.x, layout_.drawer.y});
  ImGui::InvisibleButton("splitter", {layout_.drawer.width - 4 * em, 0.35f * em});
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
  if (ImGui::IsItemActive()) preferences_.drawer_height -= ImGui::GetIO().MouseDelta.y / em;
  preferences_.drawer_height = std::clamp(preferences_.drawer_height, 8.0f, 60.0f);
  ImGui::SetCursorPos(cursor);
}

}  // namespace pf::app
