// The tree of a formula: parse.cpp grows it, layout.cpp places it.
#pragma once

#include <string>
#include <vector>

#include "app/formula/formula.hpp"

namespace pf::app {

struct Formula::Node {
  enum class Kind {
    row,       ///< its parts side by side
    letters,   ///< text set as it is
    sign,      ///< a relation or an operator: with space about it
    large,     ///< a sum or an integral
    script,    ///< parts: base, below, above; the last two may be empty rows
    fraction,  ///< parts: above, below
    root,      ///< parts: what is under it
    accent,    ///< parts: what is under it; text: the accent's name
    space      ///< of `width` em
  } kind = Kind::row;
  std::string text = {};
  bool bold = false;
  float width = 0;
  std::vector<Node> parts = {};
};

}  // namespace pf::app
