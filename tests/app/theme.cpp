#include "app/theme.hpp"

#include <doctest/doctest.h>

#include <array>

using namespace pf;
using namespace pf::app;

TEST_CASE("contrast agrees with the definition's end points") {
  CHECK(contrast({0, 0, 0, 1}, {1, 1, 1, 1}) == doctest::Approx(21));
  CHECK(contrast({0.5f, 0.5f, 0.5f, 1}, {0.5f, 0.5f, 0.5f, 1}) == doctest::Approx(1));
}

TEST_CASE("text stands out from every surface at 4.5:1 or more, in both themes") {
  for (const Theme theme : {Theme::dark, Theme::light}) {
    const Palette& p = palette(theme);
    for (const Color& surface : {p.window, p.bar, p.popup, p.frame, p.frame_hovered}) {
      CHECK(contrast(p.text, surface) >= 7);
      CHECK(contrast(p.muted, surface) >= 4.5);
    }
    for (const Color& surface : {p.window, p.bar, p.popup}) {
      CHECK(contrast(p.accent, surface) >= 4.5);
      CHECK(contrast(p.warning, surface) >= 4.5);
      CHECK(contrast(p.error, surface) >= 4.5);
    }
    CHECK(contrast(p.on_accent, p.accent_strong) >= 4.5);
  }
}
