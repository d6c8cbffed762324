#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "app/formula/node.hpp"

namespace pf::app {

namespace {

using Node = Formula::Node;
using Kind = Node::Kind;

constexpr std::array signs{
    std::pair{"alpha", "α"},   std::pair{"beta", "β"},  std::pair{"gamma", "γ"}, std::pair{"delta", "δ"},
    std::pair{"epsilon", "ε"}, std::pair{"eta", "η"},   std::pair{"theta", "θ"}, std::pair{"kappa", "κ"},
    std::pair{"lambda", "λ"},  std::pair{"mu", "μ"},    std::pair{"nu", "ν"},    std::pair{"xi", "ξ"},
    std::pair{"pi", "π"},      std::pair{"rho", "ρ"},   std::pair{"sigma", "σ"}, std::pair{"tau", "τ"},
    std::pair{"phi", "φ"},     std::pair{"psi", "ψ"},   std::pair{"omega", "ω"}, std::pair{"Delta", "Δ"},
    std::pair{"Omega", "Ω"},   std::pair{"Psi", "Ψ"},   std::pair{"nabla", "∇"}, std::pair{"partial", "∂"},
    std::pair{"infty", "∞"},   std::pair{"prime", "′"}, std::pair{"dots", "…"},  std::pair{"degree", "°"},
    std::pair{"norm", "‖"},    std::pair{"ell", "ℓ"},
};
/// With space on both sides.
constexpr std::array operators{
    std::pair{"cdot", "·"},  std::pair{"times", "×"}, std::pair{"otimes", "⊗"}, std::pair{"circ", "∘"},
    std::pair{"le", "≤"},    std::pair{"ge", "≥"},    std::pair{"ne", "≠"},     std::pair{"approx", "≈"},
    std::pair{"to", "→"},    std::pair{"in", "∈"},    std::pair{"propto", "∝"}, std::pair{"equiv", "≡"},
    std::pair{"minus", "−"}, std::pair{"pm", "±"},    std::pair{"ll", "≪"},     std::pair{"gg", "≫"},
};
constexpr std::array accents{"hat", "tilde", "bar", "dot", "ddot"};

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  Node whole() {
    Node row = this->row();
    if (!done()) throw FormulaError("A closing bracket } without an opening one in: " + std::string(text_));
    return row;
  }

 private:
  bool done() const { return at_ >= text_.size(); }
  char next() const { return text_[at_]; }

  Node row() {
    Node row;
    while (!done() && next() != '}') {
      if (next() == ' ') {
        ++at_;
        continue;
      }
      if (next() == '_' || next() == '^') {
        attach(row);
        continue;
      }
      const bool comma = next() == ',';
      row.parts.push_back(atom());
      if (comma) row.parts.push_back(space_after_comma());
    }
    return row;
  }

  /// Narrow within brackets, "(X, t)"; wide where two spaces or more set one statement off from the next.
  Node space_after_comma() {
    const std::size_t word = std::min(text_.find_first_not_of(' ', at_), text_.size());
    return {.kind = Kind::space, .width = word - at_ > 1 ? 0.9F : 0.2F};
  }

  /// A sub- or superscript to the last part of the row.
  void attach(Node& row) {
    const bool above = next() == '^';
    ++at_;
    if (row.parts.empty()) row.parts.emplace_back();
    Node& base = row.parts.back();
    if (base.kind != Kind::script) {
      Node script{.kind = Kind::script};
      script.parts = {std::move(base), Node{}, Node{}};
      base = std::move(script);
    }
    Node& place = base.parts[above ? 2 : 1];
    if (!place.parts.empty()) throw FormulaError("Two scripts at the same place in: " + std::string(text_));
    place = group();
  }

  /// {...} or one atom, as a row.
  Node group() {
    while (!done() && next() == ' ') ++at_;
    if (done()) throw FormulaError("Something is missing at the end of: " + std::string(text_));
    if (next() != '{') {
      Node row;
      row.parts.push_back(atom());
      return row;
    }
    ++at_;
    Node inside = row();
    if (done()) throw FormulaError("A bracket { is not closed in: " + std::string(text_));
    ++at_;
    return inside;
  }

  Node atom() {
    const char c = next();
    if (c == '{') return group();
    if (c == '\\') return command();
    if (std::strchr("=+<>", c) != nullptr) {
      ++at_;
      return {.kind = Kind::sign, .text = std::string(1, c)};
    }
    if (c == '-') {
      ++at_;
      return {.kind = Kind::sign, .text = "−"};
    }
    return {.kind = Kind::letters, .text = character()};
  }

  /// One UTF-8 character.
  std::string character() {
    std::size_t length = 1;
    const auto lead = static_cast<unsigned char>(next());
    if (lead >= 0xF0)
      length = 4;
    else if (lead >= 0xE0)
      length = 3;
    else if (lead >= 0xC0)
      length = 2;
    std::string found(text_.substr(at_, length));
    at_ += length;
    return found;
  }

  std::string raw_group() {
    if (done() || next() != '{') throw FormulaError("\\text needs {words} in: " + std::string(text_));
    const std::size_t end = text_.find('}', at_);
    if (end == std::string_view::npos) throw FormulaError("A bracket { is not closed in: " + std::string(text_));
    std::string found(text_.substr(at_ + 1, end - at_ - 1));
    at_ = end + 1;
    return found;
  }

  Node command() {
    ++at_;
    if (!done() && (next() == ',' || next() == ';' || next() == ' ')) {
      const float width = next() == ';' ? 0.8F : 0.2F;
      ++at_;
      return {.kind = Kind::space, .width = width};
    }
    std::string name;
    while (!done() && ((next() >= 'a' && next() <= 'z') || (next() >= 'A' && next() <= 'Z'))) name += text_[at_++];
    if (name == "frac") {
      Node above = group(), below = group();
      return {.kind = Kind::fraction, .parts = {std::move(above), std::move(below)}};
    }
    if (name == "sqrt") return {.kind = Kind::root, .parts = {group()}};
    if (name == "text") return {.kind = Kind::letters, .text = raw_group()};
    if (name == "b") return {.kind = Kind::letters, .text = raw_group(), .bold = true};
    if (name == "sum") return {.kind = Kind::large, .text = "∑"};
    if (name == "prod") return {.kind = Kind::large, .text = "∏"};
    if (name == "int") return {.kind = Kind::large, .text = "∫"};
    for (const char* accent : accents)
      if (name == accent) return {.kind = Kind::accent, .text = name, .parts = {group()}};
    for (const auto& [word, sign] : signs)
      if (name == word) return {.kind = Kind::letters, .text = sign};
    for (const auto& [word, sign] : operators)
      if (name == word) return {.kind = Kind::sign, .text = sign};
    throw FormulaError("\\" + name + " is not known in: " + std::string(text_));
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

Formula Formula::parse(std::string_view text) {
  Formula f;
  f.root_ = std::make_shared<const Node>(Parser(text).whole());
  return f;
}

std::span<const std::pair<const char*, const char*>> formula_signs() {
  return signs;
}

}  // namespace pf::app
