// What studies do to the window: their news, scenes that they open, files of theirs.
#include "app/panels/memory.hpp"
#include "app/recording.hpp"
#include "app/studies/desk.hpp"
#include "app/workbench.hpp"
#include "core/files.hpp"

namespace pf::app {

namespace fs = std::filesystem;

void Workbench::set_study_actions() {
  context_.study_folder = setup_.studies;
  context_.threads = setup_.threads;
  context_.wake = [this] {
    study_news_ = true;
    GlfwWindow::wake();
  };
  context_.adopt = [this](const Scene& scene, bool other, const std::string& message) { adopt(scene, other, message); };
}

void Workbench::follow_studies() {
  news_to_show_ = true;
  if (context_.studies) context_.studies->follow(context_);
}

void Workbench::show_studies() {
  drawer_open_ = true;
  context_.view.hide_panels = false;
  PanelMemory& m = memory(context_);
  m.plot = "Studies";
  m.show_plot = true;
  settle_ = 3;
}

bool Workbench::open_as_study(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return false;
  std::string text;
  try {
    text = read_file(file);
  } catch (const FileError&) {
    return false;  // whoever opens it as a scene says why
  }
  if (!looks_like_study(text)) return false;
  studies_of(context_).open({std::move(text), file.string(), file.parent_path()});
  show_studies();
  return true;
}

void Workbench::restore(Document to) {
  if (to.number == document_) return send_scene(std::move(to.scene));
  document_ = to.number;
  show_scene(to.scene, to.file, context_.status.state == RunState::running);
  context_.unsaved = true;
}

void Workbench::adopt(const Scene& next, bool other, const std::string& message) {
  const auto take = [this, next, other, message] {
    const bool needs_reset = !other && !only(difference(context_.scene, next), Applies::reset).empty();
    undo_.push(document(), {});
    if (other) {
      document_ = ++documents_;
      show_scene(next, {}, context_.status.state == RunState::running);
    } else {
      send_scene(next);
      if (needs_reset) act(Action::reset);
    }
    notices_.add(message);
    settle_ = 3;
  };
  if (!other && next == context_.scene) return;
  other ? settle_changes(take) : take();
}

}  // namespace pf::app
