// The window and everything in it. frame() is one turn of the loop, so that a test can take the loop's place.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/compare/lane_views.hpp"
#include "app/context.hpp"
#include "app/file_dialog.hpp"
#include "app/gl_view.hpp"
#include "app/glfw_window.hpp"
#include "app/keys.hpp"
#include "app/layout.hpp"
#include "app/notices.hpp"
#include "app/preferences.hpp"
#include "app/record/recorder.hpp"
#include "app/scene_picker.hpp"
#include "app/session.hpp"
#include "app/studies/library.hpp"
#include "app/time_line.hpp"
#include "app/tools/tool.hpp"
#include "app/undo.hpp"

namespace pf::app {

class Workbench {
 public:
  struct Setup {
    bool visible = true;
    int threads = 0;
    bool run = true;  ///< start running at once
    AtEnd at_end = AtEnd::pause;
    bool remember = true;  ///< write preferences and recent files
    PreferenceFolders folders = default_folders();
    std::filesystem::path pictures;                          ///< where F12 saves; empty: the user's folder of pictures
    std::filesystem::path studies = default_study_folder();  ///< results of studies
  };

  /// Opens the window; throws DisplayError when that cannot be done.
  Workbench(const Scene& scene, const std::filesystem::path& file, const Setup& setup);
  ~Workbench();
  Workbench(const Workbench&) = delete;
  Workbench& operator=(const Workbench&) = delete;

  /// Waits until there is something to do, at most `longest` seconds, and draws a frame where one is due. False
  /// once the user has left.
  bool frame(double longest = 10);

  /// The mouse of a script or a test in place of the screen's.
  void feed(const std::optional<GlfwWindow::Pointer>& pointer) { window_.feed(pointer); }
  void feed_key(int key, int mods) { window_.feed_key({key, mods}); }
  /// A frame drawn now: the whole window with its panels.
  Image screenshot();

  AppContext& context() { return context_; }
  const Layout& layout() const { return layout_; }
  const GlView& view() const { return *view_; }
  const LaneViews* lane_views() const { return lane_views_.get(); }  ///< null before the first comparison
  const ScenePicker& scene_picker() const { return scene_picker_; }
  const TimeLine& time_line() const { return time_line_; }
  Recorder& recorder() { return recorder_; }
  long frames_drawn() const { return frames_; }
  /// What a key or a menu item does.
  void act(Action action, int index = 0);
  /// Whether the action would do something now; menus grey out the others.
  bool possible(Action action) const;
  /// Whether the scene has the nth field: no error without an exact motion, no materials where there is one.
  bool offers_field(int index) const;
  /// Replaces the scene without asking about unsaved changes.
  void open_scene(const Scene& scene, const std::filesystem::path& file, bool run);

 private:
  using Clock = std::chrono::steady_clock;

  // workbench.cpp: the loop
  bool turn(double longest);
  void keep_preferences();
  void remember_file(const std::filesystem::path& file);
  double patience(double longest) const;
  void handle_input();
  void follow_session();
  void follow_history();
  void follow_branch();
  void follow_selection();
  void follow_slow_step();
  void close_slow_step();
  void watch();
  void follow_scale();
  void draw();
  void draw_parts();
  void draw_drawer_toggle();
  ViewMargins view_margins() const;
  bool tools_in_column() const;
  void draw_tool_bar();
  void draw_tool_choice();
  void draw_tool_options(Point2 place, float width);
  void draw_tool_button(const ToolInfo& tool);
  void draw_splitter();

  // actions.cpp
  void set_actions();
  bool change(const std::vector<Edit>& edits);
  void show_scene(const Scene& scene, const std::filesystem::path& file, bool run);
  void send_scene(Scene scene);
  void open_file(const std::filesystem::path& file);
  void load_file(const std::filesystem::path& file);
  /// With the colours of the view as it is.
  bool save_to(const std::filesystem::path& file, Scene scene);
  void save();
  void ask_open();
  void browse();
  void ask_save(const std::string& title, const std::string& extension, const std::filesystem::path& proposal,
                std::function<void(const std::filesystem::path&)> done);
  void ask_save_as();
  void pin();
  void show_bad_step();
  void deselect();
  void leave();
  /// Runs `then` at once, or after the user has said what becomes of unsaved changes.
  void settle_changes(std::function<void()> then);
  void report_file_trouble(const std::string& what) { report_trouble("file", what); }
  void report_trouble(const std::string& source, const std::string& what);
  std::string file_label() const;
  bool shipped(const std::filesystem::path& file) const;

  // compare_actions.cpp
  void follow_comparison();
  /// False: it has nothing to do with a comparison.
  bool act_on_comparison(Action action);
  void draw_lanes();
  void draw_lanes_overlay();
  /// Of the view, or of all lanes; without panels.
  Image view_picture(const PictureRequest& request);
  void draw_compare_transport();
  void set_rate(double simulated_per_wall);

  // record_actions.cpp
  /// False: it has nothing to do with pictures.
  bool act_on_record(Action action);
  void ask_picture();
  ImageText picture_text(double time) const;
  Image recorded_picture();
  void save_picture(const std::filesystem::path& file, const Image& image);
  void take_view_picture();
  void take_window_picture();
  /// Takes the picture of a state that waits for it.
  void record_frame();

  // study_actions.cpp
  void set_study_actions();
  void follow_studies();
  bool open_as_study(const std::filesystem::path& file);
  void show_studies();
  Document document() const { return {context_.scene, context_.scene_file, document_}; }
  /// To what an undo or redo gave back.
  void restore(Document to);
  void adopt(const Scene& next, bool other, const std::string& message);

  // menus.cpp, transport.cpp, dialogs.cpp
  void draw_menus();
  void draw_file_menu();
  void draw_run_menu();
  void draw_rewind_memory_menu();
  void draw_view_menu();
  void menu_item(Action action, bool checked = false);
  void draw_transport();
  void draw_transport_buttons();
  void draw_playback_choices();
  void draw_end_choices();
  void draw_clock();
  void draw_transport_status(float right_edge);
  void draw_dialogs();
  void draw_unsaved_question();
  void draw_problems();
  void draw_help();
  void draw_about();
  void draw_failure_banner();

  GlfwWindow window_;
  Preferences preferences_;
  Setup setup_;
  std::atomic<bool> news_{false};  ///< from the worker
  std::atomic<bool> study_news_{false};
  Session session_;  // after window_: its worker wakes the window until it is joined
  AppContext context_;
  UndoStack undo_;
  std::uint64_t document_ = 0, documents_ = 0;  ///< the number of the one shown; numbers given
  std::unique_ptr<GlView> view_;
  std::unique_ptr<LaneViews> lane_views_;  ///< made by the first comparison
  FileDialog file_dialog_;
  ScenePicker scene_picker_;
  Notices notices_;
  Layout layout_;
  TimeLine time_line_;
  std::uint64_t shown_branches_ = 0;

  int settle_ = 3;  ///< frames that ImGui still needs to come to rest
  long frames_ = 0;
  bool news_to_show_ = false;  ///< since the last frame
  Clock::time_point rest_until_{};
  Clock::time_point held_until_{};  ///< no frame before, while a scene is being built
  bool loading_shown_ = false;      ///< the last frame said that a scene is being built
  int mishaps_ = 0;                 ///< turns in a row that threw
  bool leaving_ = false;
  float built_scale_ = 0;  ///< of the fonts
  Theme applied_theme_ = Theme::dark;
  float menu_height_ = 0;
  std::uint64_t shown_run_ = 0;
  bool fit_next_run_ = true;
  AtEnd at_end_ = AtEnd::pause;
  double rate_ = 1;
  SnapshotRequest requested_;
  std::shared_ptr<const Snapshot> asked_about_;  ///< the state that the inspector's last question was about
  LookQuestion asked_;
  RecordLevel watched_ = RecordLevel::none;  ///< what the session was asked to keep of each step
  Clock::time_point played_at_{};            ///< when the slowly played step was last moved on
  bool drawer_open_ = false;
  std::vector<HistorySample> fresh_;

  bool show_help_ = false, show_about_ = false, show_problems_ = false;
  struct WantedPicture {
    std::filesystem::path file;  ///< empty: none
    PictureRequest request = {};
    int window = 0;  ///< of the whole window, in so many frames
  };
  WantedPicture picture_;
  Recorder recorder_;
  bool hide_mark_ = false;               ///< in the frame that is being drawn
  std::function<void()> after_changes_;  ///< waits for the answer about unsaved changes
};

}  // namespace pf::app
