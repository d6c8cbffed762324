#include "core/charts/colormap.hpp"

#include <algorithm>
#include <cmath>

namespace pf {
namespace {

using Triple = std::array<double, 3>;

float unit(double value) {
  return static_cast<float>(std::clamp(value, 0.0, 1.0));
}

/// Polynomial fit of matplotlib's viridis (Smith and van der Walt 2015, CC0) by M. Zucker (CC0), within 0.01.
Color viridis(double t) {
  constexpr Triple c[] = {{0.2777273272234177, 0.005407344544966578, 0.3340998053353061},
                          {0.1050930431085774, 1.404613529898575, 1.384590162594685},
                          {-0.3308618287255563, 0.214847559468213, 0.09509516302823659},
                          {-4.634230498983486, -5.799100973351585, -19.33244095627987},
                          {6.228269936347081, 14.17993336680509, 56.69055260068105},
                          {4.776384997670288, -13.74514537774601, -65.35303263337234},
                          {-5.435455855934631, 4.645852612178535, 26.3124352495832}};
  Triple rgb{};
  for (int k = 6; k >= 0; --k) {
    for (int a = 0; a < 3; ++a) rgb[a] = rgb[a] * t + c[k][a];
  }
  return {unit(rgb[0]), unit(rgb[1]), unit(rgb[2])};
}

double to_linear(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}
double to_srgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

/// OKLab (Ottosson 2020): equal steps look equal. L in [0, 1].
Color from_oklab(const Triple& lab) {
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(lab[0] + 0.3963377774 * lab[1] + 0.2158037573 * lab[2]);
  const double m = cube(lab[0] - 0.1055613458 * lab[1] - 0.0638541728 * lab[2]);
  const double s = cube(lab[0] - 0.0894841775 * lab[1] - 1.2914855480 * lab[2]);
  return {unit(to_srgb(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s)),
          unit(to_srgb(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s)),
          unit(to_srgb(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s))};
}

/// Two straight lines in OKLab from a light neutral grey; both ends have the same lightness, so that blue and red
/// of equal size look equally far from zero.
Color blue_grey_red(double t) {
  constexpr Triple middle{0.88, 0, 0}, blue{0.50, -0.035, -0.15}, red{0.50, 0.17, 0.075};
  const Triple& end = t < 0.5 ? blue : red;
  const double w = std::abs(2 * t - 1);
  Triple lab;
  for (int a = 0; a < 3; ++a) lab[a] = middle[a] + w * (end[a] - middle[a]);
  return from_oklab(lab);
}

double luminance(Color c) {
  return 0.2126 * to_linear(c.r) + 0.7152 * to_linear(c.g) + 0.0722 * to_linear(c.b);
}

}  // namespace

Color sample(ColormapKind kind, double t) {
  if (std::isnan(t)) return {0.5f, 0.5f, 0.5f};
  t = std::clamp(t, 0.0, 1.0);
  switch (kind) {
    case ColormapKind::sequential:
      // A stretch of an even map is even; its first sixth is too dark for a dark background.
      return viridis(0.16 + 0.84 * t);
    case ColormapKind::diverging:
      return blue_grey_red(t);
    case ColormapKind::categorical:
      break;
  }
  return categorical_color(std::min<std::size_t>(7, static_cast<std::size_t>(8 * t)));
}

std::array<std::uint8_t, 1024> colormap_texels(ColormapKind kind) {
  std::array<std::uint8_t, 1024> texels;
  for (std::size_t k = 0; k < 256; ++k) {
    const Color c = sample(kind, static_cast<double>(k) / 255);
    const float channels[] = {c.r, c.g, c.b, c.a};
    for (std::size_t a = 0; a < 4; ++a) texels[4 * k + a] = static_cast<std::uint8_t>(std::lround(255 * channels[a]));
  }
  return texels;
}

Color categorical_color(std::size_t k) {
  constexpr auto rgb = [](int r, int g, int b) {
    return Color{static_cast<float>(r) / 255, static_cast<float>(g) / 255, static_cast<float>(b) / 255};
  };
  // Okabe and Ito's order begins with the easiest to tell apart; their black is a mid grey here, to show on black.
  constexpr Color colors[] = {rgb(0, 114, 178),   rgb(230, 159, 0),  rgb(0, 158, 115),  rgb(213, 94, 0),
                              rgb(204, 121, 167), rgb(86, 180, 233), rgb(240, 228, 66), rgb(136, 136, 136)};
  return colors[k % 8];
}

double contrast_ratio(Color a, Color b) {
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

double lightness(Color color) {
  const double y = luminance(color);
  return y <= 216.0 / 24389 ? y * 24389 / 27 : 116 * std::cbrt(y) - 16;
}

}  // namespace pf
