#include "render/ink.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace pf {

namespace {
constexpr std::array segment_layout{gl::Attribute{0, 3, offsetof(Segment, from)},
                                    gl::Attribute{1, 3, offsetof(Segment, to)},
                                    gl::Attribute{2, 4, offsetof(Segment, color), GL_UNSIGNED_BYTE}};
constexpr std::array mark_layout{gl::Attribute{0, 3, offsetof(Mark, at)},
                                 gl::Attribute{1, 4, offsetof(Mark, color), GL_UNSIGNED_BYTE},
                                 gl::Attribute{2, 2, offsetof(Mark, radius)}};

void set_common(Program& program, const Frame& frame, const Anchor& anchor) {
  program.use();
  program.set("u_view_projection", frame.view_projection);
  program.set("u_offset", anchor.offset(frame));
  program.set("u_half_size", 0.5f * frame.size());
  program.set("u_scale", frame.scale());
}
}  // namespace

Ink::Ink() : segments_(sizeof(Segment), segment_layout, true), marks_(sizeof(Mark), mark_layout, true) {}

void Ink::upload(const std::vector<Segment>& segments, const std::vector<Mark>& marks) {
  segments_.upload(segments);
  marks_.upload(marks);
}

void Ink::draw(InkPrograms& programs, const Frame& frame, const Anchor& anchor, float width, float head,
               Color rim) const {
  if (segments_.count() > 0) {
    set_common(programs.segment, frame, anchor);
    programs.segment.set("u_width", width * frame.scale());
    programs.segment.set("u_head", head * frame.scale());
    if (rim.a > 0) {
      programs.segment.set("u_rim", rgba(rim));
      programs.segment.set("u_grow", std::min(1.f, width / 1.2f) * frame.scale());  // thin lines, thin rims
      segments_.draw_quads();
    }
    programs.segment.set("u_rim", glm::vec4(0));
    programs.segment.set("u_grow", 0.f);
    segments_.draw_quads();
  }
  if (marks_.count() > 0) {
    set_common(programs.marker, frame, anchor);
    marks_.draw_quads();
  }
}

}  // namespace pf
