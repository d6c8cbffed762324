// Formulae: what is typed is what is set, scripts stand where they should, and what cannot be read says why.
#include "app/formula/formula.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/charts/recording_painter.hpp"

using namespace pf;
using namespace pf::app;

namespace {

struct Set {
  explicit Set(std::string_view tex) : formula(Formula::parse(tex)) {
    formula.draw(painter, {100, 100}, 20, {});
    texts = painter.texts;
    lines = painter.lines;
  }
  Point2 place(const std::string& text) const {
    const auto found = std::find_if(texts.begin(), texts.end(), [&](const auto& t) { return t.text == text; });
    REQUIRE(found != texts.end());
    return found->at;
  }
  std::string all() const {
    std::string row;
    for (const auto& t : texts) row += t.text;
    return row;
  }
  FormulaSize measure(float size) const { return formula.measure(painter, size); }

  Formula formula;
  test::RecordingPainter painter;
  std::vector<test::RecordingPainter::Text> texts;
  std::vector<std::vector<Point2>> lines;
};

}  // namespace

TEST_CASE("letters, signs and Greek are set in their order on one baseline") {
  const Set set("\\sigma = 2\\mu \\otimes F - \\text{div } P");
  CHECK(set.all() == "σ=2μ⊗F−div P");
  float x = 0;
  for (const auto& t : set.texts) {
    CHECK(t.at.y == 100);
    CHECK(t.at.x >= x);
    x = t.at.x;
  }
  const FormulaSize size = set.measure(20);
  CHECK(size.width > x - 100);
  CHECK(size.ascent > 10);
}

TEST_CASE("subscripts stand below, superscripts above, both at one place") {
  const Set set("x_p^{n+1}y");
  CHECK(set.place("p").y > set.place("x").y);
  CHECK(set.place("n").y < set.place("x").y);
  CHECK(set.place("p").x == set.place("n").x);
  CHECK(set.place("y").x > set.place("1").x);
  CHECK(set.place("y").y == set.place("x").y);
}

TEST_CASE("limits of a sum stand below and above it, parts of a fraction over one another with a bar between") {
  const Set sum("\\sum_p^N m");
  CHECK(sum.place("p").y > sum.place("∑").y + 5);
  CHECK(sum.place("N").y < sum.place("∑").y - 15);
  const Set fraction("\\frac{a}{b}");
  REQUIRE(fraction.lines.size() == 1);
  const float bar = fraction.lines[0][0].y;
  CHECK(fraction.place("a").y < bar);
  CHECK(fraction.place("b").y > bar + 8);
  const FormulaSize size = fraction.measure(20);
  CHECK(size.descent > 8);
  CHECK(Set("\\sqrt{x}").lines.size() == 1);
  CHECK(Set("\\hat{x} + \\tilde{\\phi}").lines.size() == 2);
  CHECK(Set("\\dot{x}").painter.shapes == 1);
}

TEST_CASE("sizes grow in proportion, and what is drawn stays within what was measured") {
  const Set set("E = \\frac{1}{2 \\Delta t^2} \\norm \\hat{x} - \\tilde{x} \\norm_M^2 + \\sum_p V_p \\psi(F_p)");
  const FormulaSize one = set.measure(20), two = set.measure(40);
  CHECK(two.width == doctest::Approx(2 * one.width).epsilon(1e-4));
  CHECK(two.ascent == doctest::Approx(2 * one.ascent).epsilon(1e-4));
  for (const auto& t : set.texts) {
    CHECK(t.at.x >= 100);
    CHECK(t.at.x < 100 + one.width);
    CHECK(t.at.y > 100 - one.ascent);
    CHECK(t.at.y < 100 + one.descent);
  }
}

TEST_CASE("what is no formula says what is wrong with it") {
  for (const char* wrong : {"\\nonsense", "{a", "a}", "x_", "x_a_b", "\\frac{a}", "\\text"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(Formula::parse(wrong), FormulaError);
  }
  CHECK_NOTHROW(Formula::parse(""));
  CHECK_NOTHROW(Formula::parse("(a, b)"));
}
