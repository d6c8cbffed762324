#include "core/charts/theme.hpp"

namespace pf {
namespace {

constexpr Color rgb(unsigned hex, float alpha = 1) {
  return {static_cast<float>(hex >> 16 & 255) / 255, static_cast<float>(hex >> 8 & 255) / 255,
          static_cast<float>(hex & 255) / 255, alpha};
}

}  // namespace

// Okabe and Ito's hues and order; lightness moved until each shows on the surface. Their black is the text's colour,
// so that no series is taken for a pinned grey one.
ChartTheme light_theme(float font_size) {
  return {.surface = rgb(0xffffff),
          .text = rgb(0x1b1e24),
          .muted = rgb(0x5b616b),
          .grid = rgb(0xe3e6ea),
          .minor_grid = rgb(0xf1f2f5),
          .axis = rgb(0x8a909a),
          .pinned = rgb(0x7a7f86),
          .panel = rgb(0xffffff, 0.88f),
          .series = {rgb(0x0072b2), rgb(0xc77800), rgb(0x00936b), rgb(0xd0500a), rgb(0xb65c90), rgb(0x2b92cf),
                     rgb(0x968400), rgb(0x30343b)},
          .font_size = font_size};
}

ChartTheme dark_theme(float font_size) {
  return {.surface = rgb(0x17191d),
          .text = rgb(0xeceef1),
          .muted = rgb(0xa3a9b3),
          .grid = rgb(0x2b2f36),
          .minor_grid = rgb(0x212429),
          .axis = rgb(0x6d737d),
          .pinned = rgb(0x868c96),
          .panel = rgb(0x17191d, 0.88f),
          .series = {rgb(0x3f9fe3), rgb(0xf0a81c), rgb(0x25c197), rgb(0xf4743b), rgb(0xe08fc0), rgb(0x84d5ec),
                     rgb(0xeee055), rgb(0xd9dce1)},
          .font_size = font_size};
}

}  // namespace pf
