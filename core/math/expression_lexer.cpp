#include "core/math/expression_lexer.hpp"

#include <charconv>
#include <string>

#include "core/math/expression.hpp"

namespace pf {
namespace {

// Not <cctype>: its answers depend on the locale.
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// What people type and what they mean by it.
struct Habit {
  std::string_view typed, meant;
};
constexpr Habit habits[] = {
    {"=", "=="},     {"&", "&&"},      {"|", "||"},      {"[", "( )"},     {"{", "( )"},     {"]", "( )"},
    {"}", "( )"},    {"\u03c0", "pi"}, {"\u2212", "-"},  {"\u2013", "-"},  {"\u00d7", "*"},  {"\u00b7", "*"},
    {"\u00f7", "/"}, {"\u00b2", "^2"}, {"\u00b3", "^3"}, {"\u2264", "<="}, {"\u2265", ">="}, {"\u2260", "!="},
};

/// The whole UTF-8 character at the beginning of `text` if it is one, else its first byte.
std::string_view first_character(std::string_view text) {
  const auto byte = static_cast<unsigned char>(text[0]);
  const std::size_t length = byte >= 0xf0 ? 4 : byte >= 0xe0 ? 3 : byte >= 0xc0 ? 2 : 1;
  if (length > text.size()) return text.substr(0, 1);
  for (std::size_t i = 1; i < length; ++i)
    if ((static_cast<unsigned char>(text[i]) & 0xc0u) != 0x80u) return text.substr(0, 1);
  return text.substr(0, length);
}

std::string printable(std::string_view character) {
  const auto byte = static_cast<unsigned char>(character[0]);
  if (character.size() > 1 || (byte >= 0x20 && byte < 0x7f)) return "'" + std::string(character) + "'";
  constexpr char digits[] = "0123456789abcdef";
  return std::string("byte 0x") + digits[byte >> 4] + digits[byte & 15u];
}

}  // namespace

Token Lexer::next() {
  while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  const std::size_t begin = at_;
  if (begin == text_.size()) return {Token::Kind::end, {}, 0, begin};
  const char c = text_[begin];
  if (is_digit(c) || c == '.') return number(begin);
  if (is_letter(c)) {
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
    return {Token::Kind::name, text_.substr(begin, at_ - begin), 0, begin};
  }
  for (const std::string_view symbol :
       {"<=", ">=", "==", "!=", "&&", "||", "+", "-", "*", "/", "^", "?", ":", "<", ">", "!", "(", ")", ","}) {
    if (text_.substr(begin, symbol.size()) != symbol) continue;
    at_ += symbol.size();
    return {Token::Kind::symbol, symbol, 0, begin};
  }
  refuse(begin);
}

Token Lexer::number(std::size_t begin) {
  double value = 0;
  const char* first = text_.data() + begin;
  const auto [end, error] = std::from_chars(first, text_.data() + text_.size(), value);
  if (error == std::errc::invalid_argument) throw ExpressionError("'.' is not a number", begin);
  at_ = begin + static_cast<std::size_t>(end - first);
  const std::string_view text = text_.substr(begin, at_ - begin);
  if (error == std::errc::result_out_of_range)
    throw ExpressionError("the number " + std::string(text.substr(0, 32)) + " is out of range (1e-308 to 1e308)",
                          begin);
  return {Token::Kind::number, text, value, begin};
}

void Lexer::refuse(std::size_t position) const {
  const std::string_view character = first_character(text_.substr(position));
  std::string message = printable(character) + " has no meaning in an expression";
  for (const Habit& habit : habits)
    if (habit.typed == character) message += "; did you mean '" + std::string(habit.meant) + "'?";
  throw ExpressionError(message, position);
}

}  // namespace pf
