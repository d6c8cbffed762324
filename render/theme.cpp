#include "render/theme.hpp"

namespace pf {

namespace {
/// 0xRRGGBB and opacity.
constexpr Color hex(unsigned rgb, float alpha = 1) {
  return {static_cast<float>(rgb >> 16 & 255u) / 255.f, static_cast<float>(rgb >> 8 & 255u) / 255.f,
          static_cast<float>(rgb & 255u) / 255.f, alpha};
}
}  // namespace

RenderTheme RenderTheme::dark() {
  RenderTheme t;
  t.background_top = hex(0x20242b);
  t.background_bottom = hex(0x15181d);
  t.lattice = hex(0xaebbd0, 0.16f);
  t.cell = hex(0x6fa8ff, 0.10f);
  t.node = hex(0xa9bcd6, 0.85f);
  t.node_fixed = hex(0xffb454);
  t.node_contact = hex(0xff6ea9);
  t.arrow = hex(0xffffff, 0.96f);
  t.arrow_rim = hex(0x10141a, 0.55f);
  t.bent_grid = hex(0x7fd3ff, 0.85f);
  t.solid = hex(0x2f353f);
  t.solid_hatch = hex(0x4a5361);
  t.solid_edge = hex(0xb9c4d4);
  t.solid_3d = hex(0x7c8798);
  t.ground = hex(0x2b3038);
  t.ground_line = hex(0x454d5a);
  t.constraint = hex(0xffb454);
  t.load = hex(0xff7d6b);
  t.silhouette = hex(0x8f9db3);
  t.inverted = hex(0xff2fd0);
  t.selection = hex(0xffffff);
  t.text = hex(0xe8edf4);
  t.text_muted = hex(0xa7b1c0);
  t.panel = hex(0x14171c, 0.72f);
  t.outline = 0.32f;
  return t;
}

RenderTheme RenderTheme::light() {
  RenderTheme t;
  t.background_top = hex(0xfbfcfe);
  t.background_bottom = hex(0xe9edf2);
  t.lattice = hex(0x3d4a5e, 0.20f);
  t.cell = hex(0x2f6fd0, 0.08f);
  t.node = hex(0x4c5d76, 0.80f);
  t.node_fixed = hex(0xb86200);
  t.node_contact = hex(0xc2185b);
  t.arrow = hex(0x151b24, 0.95f);
  t.arrow_rim = hex(0xffffff, 0.60f);
  t.bent_grid = hex(0x0b6cb8, 0.80f);
  t.solid = hex(0xd3d9e1);
  t.solid_hatch = hex(0xa9b4c2);
  t.solid_edge = hex(0x4a5666);
  t.solid_3d = hex(0xc3ccd8);
  t.ground = hex(0xdfe4ea);
  t.ground_line = hex(0xbcc5d0);
  t.constraint = hex(0xb86200);
  t.load = hex(0xc23b22);
  t.silhouette = hex(0x4a5666);
  t.inverted = hex(0xd400a8);
  t.selection = hex(0x101418);
  t.text = hex(0x1b222c);
  t.text_muted = hex(0x566273);
  t.panel = hex(0xfdfefe, 0.78f);
  t.outline = 0.28f;
  return t;
}

}  // namespace pf
