// Places and paints the tree. All lengths are in em of the size at hand.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/formula/node.hpp"

namespace pf::app {

namespace {

using Node = Formula::Node;
using Kind = Node::Kind;

constexpr float letter_ascent = 0.75F, letter_descent = 0.22F;  ///< Noto Sans, of what formulae are made of
constexpr float script_scale = 0.68F, axis_height = 0.27F;

/// Measures, and paints where `painter` is not null.
class Setter {
 public:
  Setter(const Painter& ruler, Painter* painter, Color color) : ruler_(ruler), painter_(painter), color_(color) {}

  FormulaSize set(const Node& n, Point2 at, float size) {
    switch (n.kind) {
      case Kind::letters:
        return letters(n, at, size);
      case Kind::sign:
        return sign(n, at, size);
      case Kind::large:
        return large(n, at, size);
      case Kind::script:
        return script(n, at, size);
      case Kind::fraction:
        return fraction(n, at, size);
      case Kind::root:
        return root(n, at, size);
      case Kind::accent:
        return accent(n, at, size);
      case Kind::space:
        return {n.width * size, 0, 0};
      default:
        return row(n, at, size);
    }
  }

 private:
  FormulaSize measure(const Node& n, float size) { return Setter(ruler_, nullptr, color_).set(n, {}, size); }

  float text(Point2 at, const std::string& words, float size, bool bold) {
    const FontWeight weight = bold ? FontWeight::bold : FontWeight::regular;
    if (painter_) painter_->text(at, words, size, color_, TextAlign::left, weight);
    return ruler_.text_width(words, size, weight);
  }
  void line(std::span<const Point2> points, float width) {
    if (painter_) painter_->polyline(points, color_, std::max(1.0F, width));
  }

  FormulaSize row(const Node& n, Point2 at, float size) {
    FormulaSize all;
    for (std::size_t k = 0; k < n.parts.size(); ++k) {
      const Node& part = n.parts[k];
      // A sign that begins a row, or follows another one, stands close to what it belongs to.
      const bool alone = part.kind == Kind::sign && (k == 0 || n.parts[k - 1].kind == Kind::sign);
      const FormulaSize s =
          alone ? letters(part, {at.x + all.width, at.y}, size) : set(part, {at.x + all.width, at.y}, size);
      all = {all.width + s.width, std::max(all.ascent, s.ascent), std::max(all.descent, s.descent)};
    }
    return all;
  }

  FormulaSize letters(const Node& n, Point2 at, float size) {
    return {text(at, n.text, size, n.bold) + 0.02F * size, letter_ascent * size, letter_descent * size};
  }

  FormulaSize sign(const Node& n, Point2 at, float size) {
    const float space = 0.22F * size;
    return {text({at.x + space, at.y}, n.text, size, false) + 2 * space, letter_ascent * size, letter_descent * size};
  }

  FormulaSize large(const Node& n, Point2 at, float size) {
    const float bigger = 1.35F * size, drop = 0.12F * size;
    return {text({at.x, at.y + drop}, n.text, bigger, false) + 0.08F * size, 0.98F * size, 0.36F * size};
  }

  FormulaSize script(const Node& n, Point2 at, float size) {
    const Node &base = n.parts[0], &below = n.parts[1], &above = n.parts[2];
    const float small = script_scale * size;
    const FormulaSize b = measure(base, size), lo = measure(below, small), hi = measure(above, small);
    if (base.kind == Kind::large) {  // limits stand below and above
      const float width = std::max({b.width, lo.width, hi.width}) + 0.1F * size;
      set(base, {at.x + (width - b.width) / 2, at.y}, size);
      const float down = b.descent + lo.ascent + 0.02F * size, up = b.ascent + hi.descent + 0.06F * size;
      set(below, {at.x + (width - 0.1F * size - lo.width) / 2, at.y + down}, small);
      set(above, {at.x + (width - 0.1F * size - hi.width) / 2, at.y - up}, small);
      return {width, above.parts.empty() ? b.ascent : up + hi.ascent,
              below.parts.empty() ? b.descent : down + lo.descent};
    }
    set(base, at, size);
    const float down = std::max(0.24F * size, b.descent - 0.1F * size),
                up = std::max(0.38F * size, b.ascent - 0.38F * size);
    set(below, {at.x + b.width, at.y + down}, small);
    set(above, {at.x + b.width, at.y - up}, small);
    return {b.width + std::max(lo.width, hi.width) + 0.05F * size,
            above.parts.empty() ? b.ascent : std::max(b.ascent, up + hi.ascent),
            below.parts.empty() ? b.descent : std::max(b.descent, down + lo.descent)};
  }

  FormulaSize fraction(const Node& n, Point2 at, float size) {
    const float part = 0.88F * size, gap = 0.12F * size, axis = axis_height * size;
    const FormulaSize a = measure(n.parts[0], part), b = measure(n.parts[1], part);
    const float width = std::max(a.width, b.width) + 0.3F * size;
    set(n.parts[0], {at.x + (width - a.width) / 2, at.y - axis - gap - a.descent}, part);
    set(n.parts[1], {at.x + (width - b.width) / 2, at.y - axis + gap + b.ascent}, part);
    const std::array bar{Point2{at.x + 0.06F * size, at.y - axis}, Point2{at.x + width - 0.06F * size, at.y - axis}};
    line(bar, 0.06F * size);
    return {width, axis + gap + a.descent + a.ascent, b.ascent + b.descent + gap - axis};
  }

  FormulaSize root(const Node& n, Point2 at, float size) {
    const FormulaSize in = measure(n.parts[0], size);
    const float lead = 0.55F * size, top = in.ascent + 0.1F * size;
    const std::array hook{
        Point2{at.x + 0.04F * size, at.y - 0.3F * size}, Point2{at.x + 0.18F * size, at.y - 0.36F * size},
        Point2{at.x + 0.34F * size, at.y + in.descent}, Point2{at.x + lead - 0.05F * size, at.y - top},
        Point2{at.x + lead + in.width + 0.05F * size, at.y - top}};
    line(hook, 0.06F * size);
    set(n.parts[0], {at.x + lead, at.y}, size);
    return {lead + in.width + 0.1F * size, top + 0.06F * size, in.descent};
  }

  FormulaSize accent(const Node& n, Point2 at, float size) {
    FormulaSize in = set(n.parts[0], at, size);
    const bool tall = !n.parts[0].parts.empty() && !n.parts[0].parts[0].text.empty() &&
                      (std::isupper(static_cast<unsigned char>(n.parts[0].parts[0].text[0])) != 0 ||
                       n.parts[0].parts[0].text == "φ" || n.parts[0].parts[0].text == "f");
    const float y = at.y - (tall ? 0.84F : 0.64F) * size, x = at.x + in.width / 2, w = 0.17F * size;
    if (n.text == "hat") {
      const std::array roof{Point2{x - w, y + 0.02F * size}, Point2{x, y - 0.12F * size},
                            Point2{x + w, y + 0.02F * size}};
      line(roof, 0.06F * size);
    } else if (n.text == "bar") {
      const std::array bar{Point2{x - 1.2F * w, y}, Point2{x + 1.2F * w, y}};
      line(bar, 0.06F * size);
    } else if (n.text == "tilde") {
      std::array<Point2, 9> wave;
      for (std::size_t k = 0; k < wave.size(); ++k) {
        const float s = static_cast<float>(k) / 8;
        wave[k] = {x + (2 * s - 1) * 1.1F * w, y - 0.03F * size - 0.06F * size * std::sin(6.283F * s)};
      }
      line(wave, 0.06F * size);
    } else if (painter_) {
      const float side = n.text == "ddot" ? 0.11F * size : 0;
      painter_->circle({x - side, y - 0.02F * size}, 0.055F * size, color_);
      if (side > 0) painter_->circle({x + side, y - 0.02F * size}, 0.055F * size, color_);
    }
    in.ascent = std::max(in.ascent, at.y - y + 0.16F * size);
    return in;
  }

  const Painter& ruler_;
  Painter* painter_;
  Color color_;
};

}  // namespace

FormulaSize Formula::measure(const Painter& painter, float size) const {
  return root_ ? Setter(painter, nullptr, {}).set(*root_, {}, size) : FormulaSize{};
}

void Formula::draw(Painter& painter, Point2 at, float size, Color color) const {
  if (root_) Setter(painter, &painter, color).set(*root_, at, size);
}

}  // namespace pf::app
