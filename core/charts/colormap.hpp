// Colours for numbers and for categories, the same in charts, legends and the particles' textures.
#pragma once

#include <array>
#include <cstdint>

#include "core/charts/painter.hpp"

namespace pf {

enum class ColormapKind {
  sequential,  ///< magnitudes: violet - teal - yellow, lightness rises evenly
  diverging,   ///< deviations: blue - light grey - red, neutral at t = 1/2
  categorical  ///< eight distinct colours; t in [0, 1] picks one
};

/// t in [0, 1], clamped; NaN gives a mid grey. All maps keep clear of black and white, so that every colour shows on
/// a light and on a dark background, and can be told apart with the common colour-vision deficiencies.
Color sample(ColormapKind kind, double t);
/// 256 RGBA8 texels, texel k at t = k / 255.
std::array<std::uint8_t, 1024> colormap_texels(ColormapKind kind);
/// Colour of the k-th category or series (modulo 8), after Okabe and Ito (2008).
Color categorical_color(std::size_t k);

/// WCAG 2 contrast ratio of two opaque colours, in [1, 21].
double contrast_ratio(Color a, Color b);
/// CIE lightness L* of an opaque colour, in [0, 100].
double lightness(Color color);

}  // namespace pf
