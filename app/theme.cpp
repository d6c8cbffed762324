#include "app/theme.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/assets.hpp"

namespace pf::app {
namespace {

constexpr Color rgb(unsigned hex, float alpha = 1) {
  return {static_cast<float>(hex >> 16 & 255) / 255, static_cast<float>(hex >> 8 & 255) / 255,
          static_cast<float>(hex & 255) / 255, alpha};
}

constexpr Palette dark{.window = rgb(0x1b1d22),
                       .bar = rgb(0x222529),
                       .popup = rgb(0x25282e),
                       .frame = rgb(0x2e3239),
                       .frame_hovered = rgb(0x383d46),
                       .frame_active = rgb(0x424853),
                       .border = rgb(0x3a3f48),
                       .text = rgb(0xeceef1),
                       .muted = rgb(0xabb1bb),
                       .accent = rgb(0x5aa9f0),
                       .accent_strong = rgb(0x1f6fb8),
                       .on_accent = rgb(0xffffff),
                       .warning = rgb(0xffb852),
                       .error = rgb(0xff8a80)};

constexpr Palette light{.window = rgb(0xf6f7f9),
                        .bar = rgb(0xebedf0),
                        .popup = rgb(0xffffff),
                        .frame = rgb(0xe4e7eb),
                        .frame_hovered = rgb(0xd9dde3),
                        .frame_active = rgb(0xcdd2da),
                        .border = rgb(0xc9ced6),
                        .text = rgb(0x1b1e24),
                        .muted = rgb(0x4d535d),
                        .accent = rgb(0x0b66b8),
                        .accent_strong = rgb(0x0b66b8),
                        .on_accent = rgb(0xffffff),
                        .warning = rgb(0x8a4700),
                        .error = rgb(0xb3261e)};

double linear(float c) {
  return c <= 0.04045f ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}
double luminance(Color c) {
  return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}

ImVec4 vec(Color c, float alpha = 1) {
  return {c.r, c.g, c.b, c.a * alpha};
}

void set_colors(ImVec4* to, const Palette& p) {
  const ImVec4 none{0, 0, 0, 0};
  const auto set = [&](std::initializer_list<ImGuiCol> which, ImVec4 color) {
    for (const ImGuiCol i : which) to[i] = color;
  };
  set({ImGuiCol_Text}, vec(p.text));
  set({ImGuiCol_TextDisabled}, vec(p.muted));
  set({ImGuiCol_WindowBg}, vec(p.window));
  set({ImGuiCol_ChildBg, ImGuiCol_BorderShadow, ImGuiCol_ScrollbarBg, ImGuiCol_TableRowBg}, none);
  set({ImGuiCol_PopupBg}, vec(p.popup));
  set({ImGuiCol_Border, ImGuiCol_Separator, ImGuiCol_TableBorderStrong, ImGuiCol_TableBorderLight}, vec(p.border));
  set({ImGuiCol_FrameBg, ImGuiCol_Button, ImGuiCol_TableHeaderBg}, vec(p.frame));
  set({ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered}, vec(p.frame_hovered));
  set({ImGuiCol_FrameBgActive, ImGuiCol_ButtonActive}, vec(p.frame_active));
  set({ImGuiCol_MenuBarBg}, vec(p.bar));
  set({ImGuiCol_TitleBg, ImGuiCol_TitleBgActive, ImGuiCol_TitleBgCollapsed}, vec(p.popup));
  set({ImGuiCol_ScrollbarGrab}, vec(p.muted, 0.35f));
  set({ImGuiCol_ScrollbarGrabHovered}, vec(p.muted, 0.6f));
  set({ImGuiCol_ScrollbarGrabActive}, vec(p.muted, 0.8f));
  set({ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive, ImGuiCol_NavHighlight,
       ImGuiCol_DragDropTarget, ImGuiCol_PlotLines, ImGuiCol_PlotHistogram, ImGuiCol_ResizeGripActive,
       ImGuiCol_SeparatorActive, ImGuiCol_SeparatorHovered},
      vec(p.accent));
  set({ImGuiCol_Header}, vec(p.accent, 0.3f));  // what is selected in a list
  set({ImGuiCol_TabActive, ImGuiCol_TabUnfocusedActive}, vec(p.frame));
  set({ImGuiCol_HeaderHovered, ImGuiCol_TabHovered}, vec(p.frame_hovered));
  set({ImGuiCol_HeaderActive}, vec(p.frame_active));
  set({ImGuiCol_Tab, ImGuiCol_TabUnfocused, ImGuiCol_ResizeGrip, ImGuiCol_TableRowBgAlt}, none);
  set({ImGuiCol_ResizeGripHovered}, vec(p.accent, 0.6f));
  set({ImGuiCol_TextSelectedBg}, vec(p.accent, 0.35f));
  set({ImGuiCol_ModalWindowDimBg, ImGuiCol_NavWindowingDimBg}, {0, 0, 0, 0.45f});
}

void set_sizes(ImGuiStyle& style) {
  style.WindowPadding = {12, 12};
  style.FramePadding = {8, 4};
  style.CellPadding = {8, 4};
  style.ItemSpacing = {8, 8};
  style.ItemInnerSpacing = {8, 4};
  style.IndentSpacing = 16;
  style.ScrollbarSize = 12;
  style.GrabMinSize = 12;
  style.WindowBorderSize = style.FrameBorderSize = style.TabBorderSize = 0;
  style.PopupBorderSize = style.ChildBorderSize = 1;
  style.ChildRounding = 0;
  style.FrameRounding = style.GrabRounding = style.TabRounding = 4;
  style.PopupRounding = style.WindowRounding = 8;  // docks are square: see part()
  style.ScrollbarRounding = 6;
  style.WindowMenuButtonPosition = ImGuiDir_None;
  style.WindowTitleAlign = {0, 0.5f};
}

/// Latin, punctuation, Greek, sub- and superscripts, letterlike, arrows, operators, box and geometric symbols.
constexpr std::array<ImWchar, 23> ranges{0x0020, 0x017F, 0x0300, 0x0306, 0x0370, 0x03FF, 0x1E00, 0x1E9F,
                                         0x2010, 0x205F, 0x2070, 0x209F, 0x2100, 0x214F, 0x2190, 0x21FF,
                                         0x2200, 0x22FF, 0x2500, 0x25FF, 0x2713, 0x2717, 0};

void add_font(const char* text, float size) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  ImFontConfig config;
  config.OversampleH = size < 24 ? 2 : 1;
  config.OversampleV = 1;
  config.PixelSnapH = false;
  atlas.AddFontFromFileTTF(asset_path(text).c_str(), size, &config, ranges.data());
  config.MergeMode = true;
  atlas.AddFontFromFileTTF(asset_path("fonts/NotoSansMath-Regular.ttf").c_str(), size, &config, ranges.data());
}

}  // namespace

const Palette& palette(Theme theme) {
  return theme == Theme::dark ? dark : light;
}

double contrast(Color a, Color b) {
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

void apply_theme(Theme theme, float scale) {
  ImGuiStyle style;
  set_sizes(style);
  set_colors(style.Colors, palette(theme));
  style.ScaleAllSizes(scale);
  style.PopupBorderSize = style.ChildBorderSize = std::max(1.0f, std::round(scale));  // child: a menu of a menu
  ImGui::GetStyle() = style;
}

void build_fonts(float scale) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  const float em = std::round(base_em * scale), small = std::round(0.86f * base_em * scale);
  for (const float size : {em, small}) {
    add_font("fonts/NotoSans-Regular.ttf", size);
    add_font("fonts/NotoSans-Bold.ttf", size);
  }
  atlas.Build();
}

ImFont* font_for(float size, FontWeight weight) {
  // In the order of build_fonts: regular and bold of each size.
  const ImVector<ImFont*>& fonts = ImGui::GetIO().Fonts->Fonts;
  ImFont* best = fonts.front();
  for (int i = weight == FontWeight::bold ? 1 : 0; i < fonts.Size; i += 2)
    if (i < 2 || std::abs(fonts[i]->FontSize - size) < std::abs(best->FontSize - size)) best = fonts[i];
  return best;
}

void push_accent_button() {
  // The theme in use is known by its text.
  const Palette& p = ImGui::GetStyle().Colors[ImGuiCol_Text].x > 0.5f ? dark : light;
  ImGui::PushStyleColor(ImGuiCol_Button, vec(p.accent_strong));
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, vec(p.accent_strong, 0.9f));
  ImGui::PushStyleColor(ImGuiCol_ButtonActive, vec(p.accent_strong, 0.8f));
  ImGui::PushStyleColor(ImGuiCol_Text, vec(p.on_accent));
}
void pop_accent_button() {
  ImGui::PopStyleColor(4);
}

ImFont* bold_font() {
  return ImGui::GetIO().Fonts->Fonts[1];
}
ImFont* small_font() {
  return ImGui::GetIO().Fonts->Fonts[2];
}

}  // namespace pf::app
