#include "render/background.hpp"

namespace pf {

void Background::draw(const Frame& frame) {
  if (frame.options.transparent) {
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    return;
  }
  const RenderTheme& theme = frame.theme();
  const bool lattice = frame.flat() && frame.options.grid && frame.snapshot.spacing > 0;
  const double period = 10 * frame.snapshot.spacing;  // heavier lines every ten cells
  const auto phase = [&](double x) { return lattice ? x / period - std::floor(x / period) : 0.0; };
  program_.use();
  program_.set("u_top", rgb(theme.background_top));
  program_.set("u_bottom", rgb(theme.background_bottom));
  program_.set("u_lattice", lattice ? rgba(theme.lattice) : glm::vec4(0));
  program_.set("u_size", frame.size());
  program_.set("u_origin", glm::vec2(frame.viewport.x, frame.viewport.y));
  program_.set("u_phase", glm::vec2(phase(frame.origin.x()), phase(frame.origin.y())));
  program_.set("u_cell", static_cast<float>(frame.snapshot.spacing * frame.pixels_per_metre));
  program_.set("u_line", frame.scale());
  full_screen_.draw();
}

}  // namespace pf
