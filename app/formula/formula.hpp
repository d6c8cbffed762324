// Formulae in the window, typed in a small part of TeX: x_p^{n+1} = \sum_j \hat{x}_j N_j(x_p). Sub- and superscripts,
// \frac{a}{b}, \sqrt{a}, \sum and \int with limits, accents (\hat \tilde \bar \dot), \b{F} bold, \text{words}, Greek
// letters and signs by their names, \, for a thin space. Painted with any Painter, so that a page can be printed too.
#pragma once

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/charts/painter.hpp"

namespace pf::app {

/// A formula that cannot be read: which command or bracket is wrong.
class FormulaError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct FormulaSize {
  float width = 0, ascent = 0, descent = 0;  ///< of the baseline, both positive
};

class Formula {
 public:
  struct Node;
  /// Throws FormulaError.
  static Formula parse(std::string_view text);
  FormulaSize measure(const Painter& painter, float size) const;
  /// `at`: the left end of the baseline.
  void draw(Painter& painter, Point2 at, float size, Color color) const;

 private:
  std::shared_ptr<const Node> root_;
};

/// The names of all signs that \name may stand for.
std::span<const std::pair<const char*, const char*>> formula_signs();

}  // namespace pf::app
