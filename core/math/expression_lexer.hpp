// Expression text -> tokens.
#pragma once

#include <string_view>

namespace pf {

struct Token {
  enum class Kind { end, number, name, symbol };
  Kind kind = Kind::end;
  std::string_view text;     ///< as written
  double value = 0;          ///< of a number
  std::size_t position = 0;  ///< of its first character, 0-based
  bool is(std::string_view symbol) const { return kind == Kind::symbol && text == symbol; }
};

class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) {}
  /// The next token; `end` for ever after the last. Throws ExpressionError for what cannot begin one.
  Token next();

 private:
  Token number(std::size_t begin);
  [[noreturn]] void refuse(std::size_t position) const;

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace pf
