#include "app/lessons/desk.hpp"

#include <algorithm>
#include <string_view>

#include "app/panels/memory.hpp"
#include "core/diagnostics/fields.hpp"
#include "core/params/setting.hpp"

namespace pf::app {

namespace {

/// The left panel that has a setting: its place in the column.
int panel_of(std::string_view pointer) {
  constexpr std::pair<std::string_view, int> places[] = {{"/materials", 1}, {"/time", 2},   {"/integrator", 2},
                                                         {"/transfer", 3},  {"/solver", 4}, {"", 0}};
  for (const auto& [start, place] : places)
    if (pointer.starts_with(start)) return place;
  return 0;
}

bool needs_reset(const std::vector<Edit>& edits) {
  return std::any_of(edits.begin(), edits.end(), [](const Edit& e) {
    const Setting* setting = find_setting(e.pointer);
    return setting == nullptr || setting->applies == Applies::reset;
  });
}

}  // namespace

void LessonDesk::turn_to(AppContext& context, std::size_t index) {
  page_ = std::min(index, lesson_.pages.size() - 1);
  const LessonPage& p = page();
  seen_ = taken_apart_ = false;
  answer_.reset();
  shown_.clear();
  stale_run_ = context.status.run;
  const bool begins = p.scene || p.restart || needs_reset(p.set);
  waits_for_run_ = begins;
  if (p.scene) {
    Scene scene = *p.scene;
    if (!p.set.empty()) scene = edited(scene, p.set);
    context.show_scene(scene, p.run.value_or(false));
  } else {
    if (!p.set.empty()) context.change(p.set);
    if (p.run) *p.run ? context.session.run() : context.session.pause();
    if (begins) context.session.reset();
  }
  ViewState& view = context.view;
  if (const FieldInfo* field = find_field(p.view.field)) view.field = field->field;
  view.show_grid = p.view.grid.value_or(view.show_grid);
  view.show_bent_grid = p.view.bent_grid.value_or(view.show_bent_grid);
  view.show_velocities = p.view.velocities.value_or(view.show_velocities);
  view.show_shapes = p.view.shapes.value_or(view.show_shapes);
  if (!p.view.plot.empty()) context.show_plot(p.view.plot);
  context.highlight = p.highlight;
  if (!p.highlight.empty()) memory(context).open_left = panel_of(p.highlight);
}

bool LessonDesk::task_done(const AppContext& context) const {
  if (page().task.empty()) return true;
  if (context.status.edit.needs_reset) return false;
  const nlohmann::ordered_json scene = to_json(context.scene);
  return std::all_of(page().task.begin(), page().task.end(), [&](const Edit& e) {
    const nlohmann::ordered_json::json_pointer at(e.pointer);
    return scene.contains(at) && nlohmann::json(scene.at(at)) == e.value;
  });
}

Constants LessonDesk::values(const AppContext& context) const {
  Constants all = measures_.values(context.scene, context.snapshot.get());
  all.insert(all.end(), kept_.begin(), kept_.end());
  return all;
}

void LessonDesk::freeze(const AppContext& context) {
  seen_ = true;
  shown_ = values(context);
  for (const auto& keep : page().keep) {
    std::erase_if(kept_, [&](const auto& k) { return k.first == keep.first; });
    kept_.emplace_back(keep.first, measured(keep.second, shown_));
  }
  shown_ = values(context);
}

void LessonDesk::see(AppContext& context) {
  if (waits_for_run_ && context.status.run == stale_run_) return;
  waits_for_run_ = false;
  if (run_ != context.status.run) {
    run_ = context.status.run;
    measures_.begin();
  }
  const auto& reports = context.current.reports;
  if (measures_.size() > reports.size()) measures_.begin();  // the history was cut: begin anew
  const bool waits = !seen_ && !page().until.empty() && task_done(context);
  while (measures_.size() < reports.size()) {
    measures_.add(reports[measures_.size()]);
    // At the very step where it comes true, not some steps later.
    if (waits && !seen_ && !needs_snapshot(page().until) && measured(page().until, values(context)) != 0) {
      freeze(context);
      context.session.pause();
    }
  }
  if (waits && !seen_ && measures_.size() > 0 && measured(page().until, values(context)) != 0) {
    freeze(context);
    context.session.pause();
  }
}

void LessonDesk::follow(AppContext& context) {
  if (context.slow) taken_apart_ = true;
  if (context.status.state == RunState::loading) return;
  try {
    see(context);
    if (page().until.empty() && shown_.empty() && !waits_for_run_ && measures_.size() > 0) freeze(context);
  } catch (const ExpressionError&) {
    seen_ = true;  // a broken lesson does not hold the reader up
  }
  if (run_wanted_ && task_done(context) && !waits_for_run_) {
    run_wanted_ = false;
    if (page().slow)
      context.session.take_apart();
    else if (!seen() && context.status.state == RunState::paused)
      context.session.run();
  }
}

void LessonDesk::help(AppContext& context) {
  if (!task_done(context)) {
    if (!page().task.empty()) context.change(page().task);
    if (needs_reset(page().task)) {
      stale_run_ = context.status.run;
      waits_for_run_ = true;
      context.session.reset();
    }
  }
  run_wanted_ = true;
}

std::string LessonDesk::filled(const std::string& text) const {
  if (text.find('{') == std::string::npos) return text;
  try {
    return with_values(text, shown_);
  } catch (const ExpressionError&) {
    std::string dots = text;  // not measured yet
    for (std::size_t open = 0; (open = dots.find('{')) != std::string::npos;)
      dots.replace(open, dots.find('}', open) - open + 1, "…");
    return dots;
  }
}

void open_lesson(AppContext& context, Lesson lesson) {
  if (context.lesson && context.scene_file.empty()) context.unsaved = false;
  context.settle_changes([&context, lesson = std::move(lesson)] {
    const bool big = context.lesson && context.lesson->big;
    const float scale = context.lesson ? context.lesson->usual_scale : context.view.ui_scale;
    context.unsaved = false;
    context.lesson = std::make_shared<LessonDesk>(lesson);
    context.lesson->big = big;
    context.lesson->usual_scale = scale;
    context.lesson->turn_to(context, 0);
  });
}

void close_lesson(AppContext& context) {
  if (!context.lesson) return;
  if (context.lesson->big) context.view.ui_scale = context.lesson->usual_scale;
  context.lesson.reset();
  context.highlight.clear();
  // What a lesson has opened and asked for is not the reader's work.
  if (context.scene_file.empty()) context.unsaved = false;
}

void follow_lesson(AppContext& context) {
  if (context.lesson) context.lesson->follow(context);
}

}  // namespace pf::app
