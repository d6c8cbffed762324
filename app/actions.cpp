// What the user can make the window do: files, edits, the run.
#include <algorithm>
#include <cstdlib>
#include <utility>

#include "app/compare/desk.hpp"
#include "app/field_menu.hpp"
#include "app/inside/step_player.hpp"
#include "app/panels/memory.hpp"
#include "app/workbench.hpp"
#include "core/diagnostics/fields.hpp"
#include "core/files.hpp"
#include "render/picture.hpp"

namespace pf::app {
namespace {

namespace fs = std::filesystem;

fs::path picture_folder() {
  const auto existing = [](const char* value) {
    std::error_code error;
    return value && *value && fs::is_directory(value, error);
  };
  if (const char* set = std::getenv("XDG_PICTURES_DIR"); existing(set)) return set;
  if (const char* home = std::getenv("HOME")) {
    const std::string pictures = std::string(home) + "/Pictures";
    if (existing(pictures.c_str())) return pictures;
  }
  std::error_code error;
  return fs::current_path(error);
}

}  // namespace

void Workbench::set_actions() {
  context_.save_folder = setup_.pictures.empty() ? picture_folder() : setup_.pictures;
  context_.change = [this](const std::vector<Edit>& edits) { return change(edits); };
  context_.open_file = [this](const fs::path& file) { open_file(file); };
  context_.ask_file = [this](FileDialog::Request request) {
    file_dialog_.ask(std::move(request));
    settle_ = 3;
  };
  context_.ask_open = [this] { act(Action::open); };
  context_.ask_save_as = [this] { act(Action::save_as); };
  context_.save = [this] { act(Action::save); };
  context_.undo = [this] { act(Action::undo); };
  context_.redo = [this] { act(Action::redo); };
  context_.fit_view = [this] { act(Action::fit); };
  context_.save_picture = [this] { act(Action::picture); };
  context_.pin = [this] { pin(); };
  context_.show_scene = [this](const Scene& scene, bool run) { open_scene(scene, {}, run); };
  context_.settle_changes = [this](std::function<void()> then) { settle_changes(std::move(then)); };
  context_.show_plot = [this](const std::string& title) {
    drawer_open_ = true;
    PanelMemory& m = memory(context_);
    m.plot = title;
    m.show_plot = true;
    settle_ = 3;
  };
  set_study_actions();
  context_.notify = [this](const std::string& text) {
    notices_.add(text);
    settle_ = 3;
  };
}

bool Workbench::possible(Action action) const {
  const RunState state = context_.status.state;
  if (comparing(context_)) switch (action) {
      case Action::slow_step:
      case Action::step_back:
      case Action::bad_step:
      case Action::branch:
        return false;
      case Action::step:
        return context_.compare->status.state != CompareState::finished && !recorder_.on();
      default:
        break;
    }
  switch (action) {
    case Action::undo:
      return undo_.can_undo() || context_.status.stroke_is_newest;
    case Action::redo:
      return undo_.can_redo() || context_.status.stroke_was_taken_back;
    case Action::step:
      return state == RunState::paused || state == RunState::running || state == RunState::failed;
    case Action::slow_step:
      return state == RunState::paused || state == RunState::running;
    case Action::step_back:
      return state != RunState::loading && TimeLine::wanted_step(context_.status) > 0;
    case Action::bad_step:
      return time_line_.any_bad(context_);
    case Action::branch:
      return context_.status.step < context_.status.reached;
    case Action::picture:
    case Action::picture_bare:
    case Action::picture_window:
    case Action::export_picture:
    case Action::record:
    case Action::fit:
      return context_.snapshot != nullptr;
    default:
      return true;
  }
}

bool Workbench::offers_field(int index) const {
  if (index < 0 || static_cast<std::size_t>(index) >= fields().size()) return false;
  return offers(context_.scene, fields()[static_cast<std::size_t>(index)]);
}

void Workbench::act(Action action, int index) {
  ViewState& view = context_.view;
  if (act_on_comparison(action)) {
    settle_ = 3;
    return;
  }
  if (act_on_record(action)) return;
  switch (action) {
    case Action::open:
      return ask_open();
    case Action::save:
      return save();
    case Action::save_as:
      return ask_save_as();
    case Action::save_recording:
      return ask_save("Save recording", ".json", fs::path(file_stem(context_.scene.name, "scene") + "-recording.json"),
                      [this](const fs::path& file) {
                        if (!save_to(file, session_.recorded())) return;
                        if (const std::string w = session_.recording_warning(); !w.empty()) notices_.add(w);
                      });
    case Action::quit:
      return settle_changes([this] { leave(); });
    case Action::undo:
      if (context_.status.stroke_is_newest)
        session_.take_back_strokes();
      else if (auto before = undo_.undo(document()))
        restore(std::move(*before));
      break;
    case Action::redo:
      if (context_.status.stroke_was_taken_back)
        session_.bring_back_strokes();
      else if (auto after = undo_.redo(document()))
        restore(std::move(*after));
      break;
    case Action::run_pause:
      if (context_.slow) {
        context_.slow->playing = !context_.slow->playing && !context_.slow->at_end();
        break;
      }
      context_.status.state == RunState::running ? session_.pause() : session_.run();
      break;
    case Action::step:
      if (context_.slow)
        context_.slow->next();
      else
        session_.step_once();
      break;
    case Action::slow_step:
      session_.take_apart();
      break;
    case Action::step_back:
      if (context_.slow) {
        context_.slow->previous();
        break;
      }
      session_.go_to(TimeLine::wanted_step(context_.status) - 1);
      break;
    case Action::bad_step:
      show_bad_step();
      break;
    case Action::branch:
      session_.branch();
      break;
    case Action::reset:
      close_slow_step();
      if (view_) view_->cancel_tool(context_);
      session_.reset();
      break;
    case Action::fit:
      view_->fit();
      break;
    case Action::grid:
      view.show_grid = !view.show_grid;
      break;
    case Action::vectors:
      view.show_velocities = !view.show_velocities;
      break;
    case Action::crosses:
      view.show_crosses = !view.show_crosses;
      break;
    case Action::bent_grid:
      view.show_bent_grid = !view.show_bent_grid;
      break;
    case Action::shapes:
      view.show_shapes = !view.show_shapes;
      if (view.show_shapes) notices_.add("Shape functions follow the mouse; N hides them");
      break;
    case Action::field:
      if (!offers_field(index)) return;
      view.color_by(fields()[static_cast<std::size_t>(index)].field);
      if (context_.compare) context_.compare->difference = false;
      break;
    case Action::hide_panels:
      view.hide_panels = !view.hide_panels;
      if (view.hide_panels) notices_.add("Tab shows the panels again");
      break;
    case Action::full_screen:
      window_.toggle_full_screen();
      break;
    case Action::help:
      show_help_ = true;
      break;
    case Action::deselect:
      deselect();
      break;
    default:
      break;
  }
  settle_ = 3;
}

void Workbench::deselect() {
  const bool held = view_ && view_->tool_holds();
  if (view_) view_->cancel_tool(context_);  // a polygon is begun without being held
  if (held) return;
  if (context_.slow)
    close_slow_step();
  else if (context_.selected_node)
    context_.selected_node.reset();
  else if (context_.selected_particle)
    context_.selected_particle.reset();
  else if (context_.selected_item)
    context_.selected_item.reset();
  else
    context_.view.hide_panels = false;
}

bool Workbench::change(const std::vector<Edit>& edits) {
  try {
    Scene next = edited(context_.scene, edits);
    context_.problems.clear();
    if (next == context_.scene) return true;
    undo_.push(document(), edits);
    send_scene(std::move(next));
    return true;
  } catch (const InputError& error) {
    context_.problems = error.problems();
    context_.problems_source = "edit";
    settle_ = 3;
    return false;
  }
}

void Workbench::send_scene(Scene scene) {
  context_.scene = std::move(scene);
  context_.unsaved = true;
  session_.edit(context_.scene);
  if (comparing(context_)) context_.compare->comparison.edit(context_.scene);
  settle_ = 3;
}

void Workbench::open_scene(const Scene& scene, const fs::path& file, bool run) {
  undo_.clear();
  document_ = ++documents_;
  show_scene(scene, file, run);
  if (!file.empty() && !shipped(file)) remember_file(file);
}

void Workbench::show_scene(const Scene& scene, const fs::path& file, bool run) {
  if (view_) view_->cancel_tool(context_);
  context_.scene = scene;
  context_.scene_file = file;
  context_.unsaved = false;
  context_.problems.clear();
  close_slow_step();
  if (context_.compare) context_.compare->forget();
  context_.selected_particle.reset();
  context_.selected_node.reset();
  context_.selected_item.reset();
  context_.inspected.reset();
  context_.view.follow(scene.view);
  fit_next_run_ = true;
  requested_ = snapshot_request(render_options(context_, 1));
  session_.request(requested_);
  session_.open(scene, run);
  window_.set_title(scene.name.empty() ? "Pushforward" : scene.name + " – Pushforward");
  settle_ = 3;
}

void Workbench::open_file(const fs::path& file) {
  if (open_as_study(file)) return;
  settle_changes([this, file] { load_file(file); });
}

void Workbench::load_file(const fs::path& file) {
  settle_ = 3;
  try {
    if (open_as_study(file)) return;
    open_scene(load_scene(file), file, true);
  } catch (const InputError& error) {
    context_.problems = error.problems();
    context_.problems_source = file.string();
    show_problems_ = true;
  } catch (const FileError& error) {
    report_file_trouble(error.what());
  }
}

void Workbench::report_trouble(const std::string& source, const std::string& what) {
  context_.problems = {{"", what, ""}};
  context_.problems_source = source;
  show_problems_ = true;
  settle_ = 3;
}

void Workbench::pin() {
  if (context_.current.reports.empty()) return;
  RunHistory kept = context_.current;
  kept.pinned = true;
  context_.pinned.push_front(std::move(kept));
  settle_ = 3;
}

void Workbench::show_bad_step() {
  const auto bad = time_line_.next_bad(context_);
  if (!bad) return;
  session_.go_to(bad->step);
  notices_.add("Step " + std::to_string(bad->step) + ": " + bad->why);
  settle_ = 3;
}

void Workbench::leave() {
  leaving_ = true;
}

void Workbench::settle_changes(std::function<void()> then) {
  settle_ = 3;
  if (!context_.unsaved) return then();
  after_changes_ = std::move(then);  // draw_unsaved_question() asks
}

}  // namespace pf::app
