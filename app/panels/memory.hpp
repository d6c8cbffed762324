// What the panels and tools remember from one frame to the next; AppContext owns it, nothing here is global.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/context.hpp"
#include "app/panels/gallery.hpp"
#include "app/panels/runs.hpp"
#include "app/widgets/number_control.hpp"

namespace pf::app {

struct Lesson;  // app/lessons/lesson.hpp

struct PanelMemory {
  // The scene being edited as JSON, so that a pointer finds its value; remade when the scene changes.
  Scene scene;
  nlohmann::ordered_json json;
  nlohmann::ordered_json opened;   ///< as it was opened or saved: what "restore" goes back to
  nlohmann::ordered_json running;  ///< as the run was built: tells which settings wait for a reset
  std::uint64_t run = 0;
  bool filled = false, unsaved = false;
  int frame = -1;  ///< ImGui's, of the last update

  Typing typing;
  int open_left = 0;                           ///< index into the left panels, -1: all closed
  int shown_left = 0;                          ///< the one that was open in the last frame
  bool plot_menu = false;                      ///< plots are chosen from a menu: their tabs have no room
  std::map<std::string, bool> panel_narrow;    ///< laid out as if a scroll bar stood beside it
  std::map<std::string, float> panel_heights;  ///< of each left panel's contents when it was drawn last
  std::string plot;                            ///< title of the bottom panel shown
  bool show_plot = false;                      ///< bring it to the front in the next frame
  std::string scene_material;                  ///< chosen in the material panel
  GalleryMemory gallery;
  PlotMemory plots;
  std::shared_ptr<const std::vector<Lesson>> lessons;  ///< those that are shipped, read when first asked for
};

/// The memory of `context`, made on the first call and brought up to date with this frame's scene, run and pins.
PanelMemory& memory(AppContext& context);

}  // namespace pf::app
