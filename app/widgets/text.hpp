// Text and small layout helpers that all panels share. Sizes are in em (the font's size), so that every scale
// looks the same.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

namespace pf::app {

inline float em(float count = 1) {
  return ImGui::GetFontSize() * count;
}

/// Wrapped at the window's right edge.
void paragraph(std::string_view text);
void muted(std::string_view text);
/// Something to act on: amber, wrapped.
void warning(std::string_view text);
ImVec4 warning_color();
/// The theme's accent.
ImVec4 accent_color();
/// A small heading with space above it.
void heading(const char* text);
/// Space between groups, in em.
void gap(float height = 0.5F);
/// Tooltip over the last item, wrapped at 24 em, after a short rest of the mouse.
void tooltip(std::string_view text);
/// Label left, value right, on one line where both fit and on two where they do not.
void property(std::string_view label, std::string_view value);
/// A link-like button without a frame.
bool text_button(const char* label);
/// A framed button whose label always fits: as wide as it needs, on the current line if there is room, else on
/// the next.
bool flow_button(const char* label, bool first);
/// ImGui's, with outlines.
bool tick_box(const char* label, bool* value);
bool outlined_radio(const char* label, bool chosen);
bool outlined_radio(const char* label, int* choice, int value);
/// Like ImGui::Checkbox, the label wrapped.
bool checkbox(const char* id, std::string_view label, bool* value);
/// A thin bar over the whole width, `share` of it filled.
void progress_bar(double share);
/// Starts a group that can be folded; closed at first unless `open`.
bool foldable(const char* label, bool open = false);

/// ImGui::BeginPopupModal with its title in bold letters.
bool begin_titled_modal(const char* title, int flags);

inline void text_unformatted(std::string_view text) {
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
}

}  // namespace pf::app
