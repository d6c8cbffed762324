// What every panel and mouse tool may see and do. Panels read it and call its actions; they own no state of
// the run.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/file_dialog.hpp"
#include "app/session.hpp"
#include "core/scene/scene.hpp"
#include "core/snapshot.hpp"

namespace pf::app {

enum class Theme { dark, light };

/// What is shown and how: nothing here touches the physics.
struct ViewState {
  Field field = Field::speed;
  bool lock_range = false;
  double range_min = 0, range_max = 1;  ///< of the colour map, in the field's unit
  bool log_colors = false;
  std::optional<bool> symmetric = {};  ///< about the field's centre; nothing: as the field is
  bool show_histogram = true;          ///< beside the colour bar
  bool show_particles = true;
  bool deformed_particles = true;  ///< 2D: squares mapped by F; 3D: F-ellipsoids; else points, spheres
  bool show_grid = false;          ///< lattice, active cells and nodes
  bool show_velocities = false;    ///< node velocities as arrows
  bool show_crosses = false;       ///< principal stresses
  bool show_bent_grid = false;     ///< images of the grid lines under phi^
  double bent_magnification = 1;
  bool show_boundaries = true;
  bool show_shapes = false;  ///< the shape functions about the point under the mouse
  Theme theme = Theme::dark;
  float ui_scale = 1;
  bool hide_panels = false;  ///< Tab

  /// With the range and scale that the field itself has.
  void color_by(Field by) {
    field = by;
    lock_range = log_colors = false;
    symmetric.reset();
  }
  /// As a scene asks for; what it does not name stays.
  void follow(const ViewSettings& scene) {
    const FieldInfo* info = find_field(scene.color_by);
    color_by(info ? info->field : field);
    log_colors = scene.color_log;
    if (!scene.color_min || !scene.color_max) return;
    lock_range = true;
    range_min = *scene.color_min;
    range_max = *scene.color_max;
  }
  /// What a scene that is saved now asks for.
  ViewSettings settings() const {
    ViewSettings scene;
    scene.color_by = field_info(field).key;
    scene.color_log = log_colors;
    if (!lock_range || !(range_min < range_max) || (log_colors && !(range_min > 0))) return scene;
    scene.color_min = range_min;
    scene.color_max = range_max;
    return scene;
  }
};

/// What a scene is made of, as the outline lists it.
enum class ItemKind { material, body, boundary, constraint, load, probe };
struct SceneItem {
  ItemKind kind = ItemKind::body;
  std::size_t index = 0;
  bool operator==(const SceneItem&) const = default;
};

/// Curves of one run, kept for the plots.
struct RunHistory {
  std::string label;
  bool pinned = false;
  std::vector<StepReport> reports;
  std::vector<std::vector<ProbeReading>> probes;  ///< one list a report
};

struct PanelMemory;  // app/panels/memory.hpp
struct StudyDesk;    // app/studies/desk.hpp
struct CompareDesk;  // app/compare/desk.hpp
class AdviceDesk;    // app/advice/desk.hpp
class StepPlayer;    // app/inside/step_player.hpp
class LessonDesk;    // app/lessons/desk.hpp

struct AppContext {
  explicit AppContext(Session& of) : session(of) {}

  Session& session;

  // The scene being edited; a panel changes it only through change().
  Scene scene;
  std::filesystem::path scene_file;  ///< empty: not saved yet
  bool unsaved = false;
  std::filesystem::path save_folder;   ///< where pictures and plots go without asking
  std::filesystem::path study_folder;  ///< where results of studies are kept; "" keeps none

  ViewState view;
  std::shared_ptr<const Snapshot> snapshot;  ///< this frame's; may be null
  SessionStatus status;                      ///< this frame's
  RunHistory current;
  std::deque<RunHistory> pinned;
  std::optional<std::uint32_t> selected_particle;
  std::optional<SceneItem> selected_item;  ///< of the outline
  std::string tool = "grab";               ///< key of the tool in hand
  std::optional<ParticleState> inspected;
  std::optional<NodeIndex> selected_node;
  std::optional<Look> looked;                ///< at the selected particle and node, at the newest state
  std::shared_ptr<const StepRecord> record;  ///< of the newest step, where it was asked for
  bool wants_record = false;                 ///< some panel of this frame shows where residuals are
  std::shared_ptr<StepPlayer> slow;          ///< one step played slowly; null: none
  std::shared_ptr<LessonDesk> lesson;        ///< null: no lesson is open
  std::string highlight;                     ///< pointer of a setting that the lesson points at; "": none
  std::vector<Problem> problems;             ///< of the last refused edit or scene file, shown with their pointers
  std::string problems_source;

  // Actions, supplied by the window.
  /// Applies edits to the scene (validated; refused ones leave it and fill `problems`), sends it to the session,
  /// records undo. True when accepted.
  std::function<bool(const std::vector<Edit>&)> change;
  /// Replaces the scene by another state of it in one undo step, and begins the run anew where that is needed; or,
  /// `other`, by another scene, after the user has said what becomes of unsaved changes. Shows `message` then.
  std::function<void(const Scene&, bool other, const std::string& message)> adopt;
  std::function<void(const std::filesystem::path&)> open_file;
  std::function<void(FileDialog::Request)> ask_file;
  std::function<void()> wake;  ///< draw a frame soon; from any thread
  std::function<void()> ask_open, ask_save_as, save, undo, redo, fit_view, save_picture, pin;
  /// Shows a scene of a lesson, without a question about changes and without a place among the recent files.
  std::function<void(const Scene&, bool run)> show_scene;
  /// Runs `then` at once, or after the user has said what becomes of unsaved changes.
  std::function<void(std::function<void()> then)> settle_changes;
  /// Shows a plot of the drawer by its title.
  std::function<void(const std::string&)> show_plot;
  std::function<void(const std::string&)> notify;  ///< a short message at the window's edge

  /// What panels and tools remember between frames (open panel, half-typed values, gallery); made by the first one.
  std::shared_ptr<PanelMemory> memory;
  std::shared_ptr<StudyDesk> studies;    ///< made by studies_of() (app/studies/desk.hpp)
  std::shared_ptr<CompareDesk> compare;  ///< made by compare_of() (app/compare/desk.hpp)
  std::shared_ptr<AdviceDesk> advice;    ///< made by advice_of() (app/advice/desk.hpp)
  int threads = 0;                       ///< of a simulation; 0: all
};

/// A panel of the left column, the right inspector or the bottom drawer: one file in panels/, one line in its table.
enum class Dock { left, right, bottom };
struct Panel {
  const char* title;
  Dock dock;
  /// False hides it: a scene without a boundary shows no friction.
  bool (*relevant)(const AppContext&);
  void (*draw)(AppContext&);
};
const std::vector<Panel>& panels();

}  // namespace pf::app
