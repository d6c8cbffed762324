// The looks of the window: one accent colour on grey surfaces, a rhythm of 4 pixels, a real font.
#pragma once

#include <span>

#include "app/context.hpp"
#include "core/charts/painter.hpp"

struct ImFont;

namespace pf::app {

/// The colours that everything is made of. `text` and `muted` have a contrast of at least 4.5:1 on every surface,
/// `on_accent` on the accent colour.
struct Palette {
  Color window;  ///< panels
  Color bar;     ///< menu and transport bars
  Color popup;   ///< menus, tooltips, dialogs
  Color frame;   ///< fields, sliders, buttons
  Color frame_hovered, frame_active;
  Color border;
  Color text, muted;
  Color accent, accent_strong;  ///< marks and lines; filled buttons
  Color on_accent;
  Color warning, error;  ///< as text
};
const Palette& palette(Theme theme);

/// WCAG's contrast ratio of two opaque colours, 1 to 21.
double contrast(Color a, Color b);

/// Height of the interface's text at 100 % [pixels]; 1 em.
inline constexpr float base_em = 15;
inline constexpr float smallest_scale = 0.75f, largest_scale = 3;

/// Sets ImGui's style. `scale`: of 100 %, the screen's and the user's multiplied.
void apply_theme(Theme theme, float scale);
/// Builds the font atlas for text of base_em * scale pixels, regular and bold, and a smaller size for charts and
/// notes. Throws FileError when a font is missing. Call outside of a frame; the texture is the caller's to renew.
void build_fonts(float scale);

/// Whichever size was built that comes nearest.
ImFont* font_for(float size, FontWeight weight);
/// The one button of a dialog that goes on: filled with the accent colour.
void push_accent_button();
void pop_accent_button();
ImFont* bold_font();
ImFont* small_font();

}  // namespace pf::app
