// Scene: the gallery, what the open scene is, gravity, and its bodies, walls and grid.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/panels/memory.hpp"
#include "app/panels/panels.hpp"
#include "app/widgets/setting_widget.hpp"
#include "app/widgets/text.hpp"
#include "core/assets.hpp"
#include "core/scene/scene_io.hpp"

namespace pf::app {

namespace {

void list_once(GalleryMemory& gallery) {
  if (gallery.listed) return;
  gallery.listed = true;
  try {
    gallery.entries = list_scenes(asset_path("scenes"));
  } catch (const FileError&) {
    // No assets: the gallery says so.
  }
}

/// A picture with the scene's name below; true when clicked.
bool tile(GalleryEntry& entry, float width, bool open) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float picture_height = width * 0.62F, pad = em(0.25F);
  const ImVec2 text = ImGui::CalcTextSize(entry.name.c_str(), nullptr, false, width - 2 * pad);
  const ImVec2 size(width, picture_height + pad + text.y + pad);
  const bool pressed = ImGui::InvisibleButton(entry.file.string().c_str(), size);
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  const ImVec2 end(at.x + size.x, at.y + size.y), picture_end(at.x + width, at.y + picture_height);
  draw.AddRectFilled(at, end, ImGui::GetColorU32(hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg), rounding);
  if (const Thumbnail* picture = thumbnail(entry)) {
    // Crop to the tile's shape, centred.
    const float wanted = width / picture_height;
    const float have = static_cast<float>(picture->width) / static_cast<float>(std::max(picture->height, 1));
    const ImVec2 cut = have > wanted ? ImVec2((1 - wanted / have) / 2, 0) : ImVec2(0, (1 - have / wanted) / 2);
    draw.AddImageRounded(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(picture->texture)), at, picture_end,
                         cut, ImVec2(1 - cut.x, 1 - cut.y), IM_COL32_WHITE, rounding, ImDrawFlags_RoundCornersTop);
  } else {
    const char* kind = entry.dimension == 3 ? "3D" : "2D";
    const ImVec2 k = ImGui::CalcTextSize(kind);
    draw.AddText(ImVec2(at.x + (width - k.x) / 2, at.y + (picture_height - k.y) / 2),
                 ImGui::GetColorU32(ImGuiCol_TextDisabled), kind);
  }
  draw.AddText(ImGui::GetFont(), ImGui::GetFontSize(), ImVec2(at.x + pad, at.y + picture_height + pad),
               ImGui::GetColorU32(ImGuiCol_Text), entry.name.c_str(), nullptr, width - 2 * pad);
  if (open) draw.AddRect(at, end, ImGui::GetColorU32(accent_color()), rounding, 0, em(0.12F));
  tooltip(entry.about);
  return pressed;
}

void draw_gallery(AppContext& context, GalleryMemory& gallery) {
  list_once(gallery);
  if (gallery.entries.empty()) {
    muted("No shipped scenes were found. Open one with Ctrl+O or drop a file on the window.");
    return;
  }
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  ImGui::InputTextWithHint("##filter", "Find a scene", &gallery.filter);
  std::vector<std::pair<int, std::size_t>> found;
  for (std::size_t i = 0; i < gallery.entries.size(); ++i) {
    const GalleryEntry& e = gallery.entries[i];
    const int score =
        std::max(2 * fuzzy_score(gallery.filter, e.name), fuzzy_score(gallery.filter, e.file.stem().string()));
    if (score >= 0) found.emplace_back(-score, i);
  }
  if (found.empty()) muted("No scene has these letters in its name.");
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  const float space = em(0.5F);
  const float width = std::floor((ImGui::GetContentRegionAvail().x - space) / 2);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(space, space));
  std::error_code error;
  for (std::size_t i = 0; i < found.size(); ++i) {
    GalleryEntry& entry = gallery.entries[found[i].second];
    if (i % 2 == 1) ImGui::SameLine();
    const bool open = !context.scene_file.empty() && std::filesystem::equivalent(entry.file, context.scene_file, error);
    if (tile(entry, width, open)) context.open_file(entry.file);
  }
  ImGui::PopStyleVar();
}

void draw_info(AppContext& context) {
  const Scene& scene = context.scene;
  heading("Open scene");
  paragraph(scene.name.empty() ? "Untitled" : scene.name);
  if (!scene.about.empty()) muted(scene.about);
  gap(0.25F);
  property("Dimension", scene.dimension == 3 ? "3D" : "2D, plane strain");
  if (context.snapshot) property("Particles", std::to_string(context.snapshot->particles));
  if (context.snapshot && context.snapshot->report.active_nodes > 0)
    property("Grid nodes in use", std::to_string(context.snapshot->report.active_nodes));
  gap();
}

void draw_bodies(AppContext& context) {
  for (std::size_t i = 0; i < context.scene.bodies.size(); ++i) {
    const Body& body = context.scene.bodies[i];
    const std::string index = std::to_string(i);
    std::string name = body.name.empty() ? "Body " + std::to_string(i + 1) : body.name;
    if (!foldable(name.append("###body").append(index).c_str())) continue;
    for (const char* key : {"velocity", "particles_per_axis", "sampling", "seed"})
      setting_widget(context, pointer_to({"bodies", index, key}));
  }
}

void draw_walls(AppContext& context) {
  for (std::size_t i = 0; i < context.scene.boundaries.size(); ++i) {
    const std::string index = std::to_string(i);
    std::string name = "Wall " + std::to_string(i + 1);
    if (!foldable(name.append("###wall").append(index).c_str())) continue;
    for (const char* key : {"contact", "friction", "velocity"})
      setting_widget(context, pointer_to({"boundaries", index, key}));
  }
}

}  // namespace

void draw_scene_panel(AppContext& context) {
  PanelMemory& m = memory(context);
  draw_gallery(context, m.gallery);
  draw_info(context);
  setting_widget(context, "/gravity");
  if (context.highlight.starts_with("/grid")) ImGui::SetNextItemOpen(true);  // a lesson speaks of what is in there
  if (foldable("Grid, bodies and walls")) {
    setting_widget(context, "/grid/spacing");
    setting_widget(context, "/grid/basis");
    draw_bodies(context);
    draw_walls(context);
  }
}

}  // namespace pf::app
