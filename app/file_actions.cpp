// Files: what is opened, what is saved, and under which name.
#include <algorithm>
#include <utility>

#include "app/workbench.hpp"
#include "core/assets.hpp"
#include "core/files.hpp"

namespace pf::app {
namespace {

namespace fs = std::filesystem;

fs::path scenes_folder() {
  try {
    return asset_path("scenes");
  } catch (const FileError&) {
    return {};
  }
}

}  // namespace

bool Workbench::save_to(const fs::path& file, Scene scene) {
  scene.view = context_.view.settings();
  try {
    save_scene(scene, file);
    remember_file(file);
    notices_.add("Saved " + file.string());
    settle_ = 3;
    return true;
  } catch (const FileError& error) {
    report_file_trouble(error.what());
    return false;
  }
}

bool Workbench::shipped(const fs::path& file) const {
  std::error_code error;
  const fs::path folder = fs::canonical(scenes_folder(), error);
  return !error && fs::weakly_canonical(file, error).parent_path() == folder;
}

void Workbench::save() {
  // The scenes that come with the program stay as they came.
  if (context_.scene_file.empty() || shipped(context_.scene_file)) return ask_save_as();
  if (save_to(context_.scene_file, context_.scene)) context_.unsaved = false;
}

void Workbench::ask_save_as() {
  const bool ours = !context_.scene_file.empty() && !shipped(context_.scene_file);
  const fs::path proposal = ours ? context_.scene_file : fs::path(file_stem(context_.scene.name, "scene") + ".json");
  ask_save("Save scene", ".json", proposal, [this](const fs::path& file) {
    if (!save_to(file, context_.scene)) return;
    context_.scene_file = file;
    context_.unsaved = false;
    if (after_changes_) std::exchange(after_changes_, {})();
  });
}

void Workbench::ask_open() {
  settle_changes([this] {
    scene_picker_.open(scenes_folder(), preferences_.recent);
    settle_ = 3;
  });
}

void Workbench::browse() {
  settle_changes([this] {
    FileDialog::Request request;
    request.title = "Open scene";
    request.start = context_.scene_file.empty() ? fs::path() : context_.scene_file.parent_path();
    request.places = {scenes_folder()};
    for (const fs::path& recent : preferences_.recent)
      if (std::find(request.places.begin(), request.places.end(), recent.parent_path()) == request.places.end())
        request.places.push_back(recent.parent_path());
    request.done = [this](const fs::path& file) { load_file(file); };
    file_dialog_.ask(std::move(request));
    settle_ = 3;
  });
}

void Workbench::ask_save(const std::string& title, const std::string& extension, const fs::path& proposal,
                         std::function<void(const fs::path&)> done) {
  FileDialog::Request request;
  request.purpose = FileDialog::Purpose::save;
  request.title = title;
  request.extension = extension;
  request.start = proposal;
  for (const fs::path& recent : preferences_.recent)
    if (std::find(request.places.begin(), request.places.end(), recent.parent_path()) == request.places.end())
      request.places.push_back(recent.parent_path());
  request.done = std::move(done);
  file_dialog_.ask(std::move(request));
  settle_ = 3;
}

}  // namespace pf::app
