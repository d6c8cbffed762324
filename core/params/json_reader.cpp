#include "core/params/json_reader.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "core/params/json_text.hpp"
#include "core/params/pointer.hpp"

namespace pf {
namespace {

using LineMap = std::unordered_map<std::string, int>;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Recursive descent; the depth limit bounds the recursion.
class Parser {
 public:
  Parser(std::string_view text, std::vector<Problem>& problems, const JsonLimits& limits, LineMap* wanted)
      : text_(text), problems_(problems), limits_(limits), wanted_(wanted) {}

  Json document() {
    refuse_other_encodings();
    skip_space();
    if (at_ == text_.size()) stop("nothing", "a JSON object { ... }");
    Json value = read_value(0);
    skip_space();
    if (at_ < text_.size())
      stop(here() + " after the end of the document", "one JSON value, then nothing but comments");
    return value;
  }

 private:
  [[noreturn]] void stop(std::string found, std::string allowed) const {
    throw InputError("", {Problem{path_, std::move(found), std::move(allowed), line_}});
  }
  void note(std::string found, std::string allowed) {
    if (problems_.size() < 100) problems_.push_back({path_, std::move(found), std::move(allowed), line_});
  }

  /// What stands at the reading position, for a message.
  std::string here() const {
    if (at_ >= text_.size()) return "the end of the text";
    return quoted_excerpt(text_.substr(at_));
  }

  void refuse_other_encodings() const {
    if (text_.starts_with("\xEF\xBB\xBF")) stop("a byte order mark", "UTF-8 without a byte order mark");
    if (text_.starts_with("\xFE\xFF") || text_.starts_with("\xFF\xFE")) stop("UTF-16 text", "UTF-8 text");
  }

  void skip_space() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\n') ++line_;
      if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
        ++at_;
      } else if (text_.substr(at_, 2) == "//") {
        const std::size_t end = text_.find('\n', at_);
        at_ = end == std::string_view::npos ? text_.size() : end;
      } else {
        return;
      }
    }
  }
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool accept(char c) {
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  Json read_value(int depth) {
    if (++values_ > limits_.values)
      stop("more than " + std::to_string(limits_.values) + " values", "at most that many in one file");
    if (depth > limits_.depth)
      stop("brackets more than " + std::to_string(limits_.depth) + " deep", "at most that many inside one another");
    if (wanted_) {
      if (const auto it = wanted_->find(path_); it != wanted_->end()) it->second = line_;
    }
    switch (peek()) {
      case '{':
        return read_object(depth);
      case '[':
        return read_array(depth);
      case '"':
        return read_string();
      case 't':
        return read_word("true", true);
      case 'f':
        return read_word("false", false);
      case 'n':
        return read_word("null", nullptr);
      default:
        return read_number();
    }
  }

  Json read_word(std::string_view word, Json value) {
    if (text_.substr(at_, word.size()) != word) stop(here(), value_allowed);
    at_ += word.size();
    return value;
  }

  Json read_object(int depth) {
    Json object = Json::object();
    auto& members = object.get_ref<Json::object_t&>();
    std::unordered_set<std::string> keys;
    const std::size_t parent = path_.size();
    ++at_;
    skip_space();
    if (accept('}')) return object;
    while (true) {
      if (peek() != '"') stop(here(), members.empty() ? "a key in double quotes, or }" : "a key in double quotes");
      std::string key = read_string();
      skip_space();
      if (!accept(':')) stop(here() + " after the key \"" + key + '"', "a colon");
      skip_space();
      path_ += pointer_step(key);
      const bool fresh = keys.insert(key).second;
      if (!fresh) note("the key \"" + key + "\" a second time", "each key once in an object");
      Json value = read_value(depth + 1);
      if (fresh) members.emplace_back(std::move(key), std::move(value));
      path_.resize(parent);
      skip_space();
      if (accept('}')) return object;
      if (!accept(',')) stop(here(), "a comma or }");
      skip_space();
    }
  }

  Json read_array(int depth) {
    Json array = Json::array();
    auto& items = array.get_ref<Json::array_t&>();
    const std::size_t parent = path_.size();
    ++at_;
    skip_space();
    if (accept(']')) return array;
    while (true) {
      path_ += '/' + std::to_string(items.size());
      items.push_back(read_value(depth + 1));
      path_.resize(parent);
      skip_space();
      if (accept(']')) return array;
      if (!accept(',')) stop(here(), "a comma or ]");
      skip_space();
    }
  }

  std::string read_string() {
    ++at_;
    std::string out;
    while (true) {
      if (at_ >= text_.size()) stop("text that has no end", "a closing double quote");
      const char c = text_[at_];
      if (c == '"') break;
      if (c == '\\') {
        read_escape(out);
      } else if (static_cast<unsigned char>(c) < 0x20) {
        stop("a line break or control character in a text", "text on one line; \\n for a line break");
      } else {
        const std::size_t length = utf8_length(text_.substr(at_));
        if (length == 0) stop("bytes that are not UTF-8", "text in UTF-8");
        out.append(text_.substr(at_, length));
        at_ += length;
      }
    }
    ++at_;
    return out;
  }

  void read_escape(std::string& out) {
    static constexpr std::string_view from = "\"\\/bfnrt", to = "\"\\/\b\f\n\r\t";
    const char c = text_.size() > at_ + 1 ? text_[at_ + 1] : '\0';
    if (const std::size_t k = from.find(c); c != '\0' && k != std::string_view::npos) {
      out += to[k];
      at_ += 2;
      return;
    }
    if (c != 'u') stop(here(), "one of \\\" \\\\ \\/ \\b \\f \\n \\r \\t \\uXXXX");
    std::uint32_t code = read_hex();
    if (code >= 0xD800 && code < 0xDC00 && text_.substr(at_, 2) == "\\u") {
      const std::uint32_t low = read_hex();
      if (low < 0xDC00 || low > 0xDFFF) stop("half a surrogate pair", "\\uD8xx\\uDCxx pairs");
      code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
    }
    if (code == 0 || (code >= 0xD800 && code <= 0xDFFF)) stop("a \\u that is no character", "Unicode characters");
    append_utf8(out, code);
  }

  /// The four digits of \uXXXX at the reading position.
  std::uint32_t read_hex() {
    std::uint32_t code = 0;
    const std::string_view digits = text_.substr(at_ + 2, 4);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (error != std::errc() || digits.size() != 4 || end != digits.data() + 4) stop(here(), "\\u and four hex digits");
    at_ += 6;
    return code;
  }

  void skip_digits() {
    if (!is_digit(peek())) stop(here(), "a digit");
    while (is_digit(peek())) ++at_;
  }

  Json read_number() {
    const std::size_t begin = at_;
    bool integral = true;
    accept('-');
    if (!is_digit(peek())) {
      at_ = begin;
      stop(here(), value_allowed);
    }
    if (accept('0')) {
      if (is_digit(peek())) stop("a number with a leading 0", "numbers without leading zeros");
    } else {
      skip_digits();
    }
    if (accept('.')) {
      integral = false;
      skip_digits();
    }
    if (accept('e') || accept('E')) {
      integral = false;
      if (!accept('+')) accept('-');
      skip_digits();
    }
    return to_number(text_.substr(begin, at_ - begin), integral);
  }

  Json to_number(std::string_view digits, bool integral) {
    const char* const end = digits.data() + digits.size();
    if (integral && digits != "-0") {
      if (std::uint64_t u = 0; std::from_chars(digits.data(), end, u).ec == std::errc() && digits[0] != '-') return u;
      if (std::int64_t i = 0; std::from_chars(digits.data(), end, i).ec == std::errc()) return i;
    }
    double value = 0;
    if (std::from_chars(digits.data(), end, value).ec == std::errc()) return value;
    if (is_tiny(digits)) return 0.0;
    note(quoted_excerpt(digits), "numbers that fit into double precision, up to 1.7e308");
    return std::numeric_limits<double>::quiet_NaN();
  }

  /// Of a number out of double's range: is it too small rather than too large?
  static bool is_tiny(std::string_view digits) {
    const std::size_t e = digits.find_first_of("eE");
    const std::string_view mantissa = digits.substr(0, e);
    const std::size_t first = mantissa.find_first_of("123456789");
    if (first == std::string_view::npos) return true;
    const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
    double magnitude = static_cast<double>(point) - static_cast<double>(first);
    if (e != std::string_view::npos) {
      std::string_view text = digits.substr(e + 1);
      const bool negative = text[0] == '-';
      if (text[0] == '+' || negative) text.remove_prefix(1);
      double exponent = 0;
      for (const char c : text) exponent = std::min(exponent * 10 + (c - '0'), 1e15);
      magnitude += negative ? -exponent : exponent;
    }
    return magnitude < 0;
  }

  static constexpr const char* value_allowed = "an object, an array, a text in double quotes, a number, true or false";

  std::string_view text_;
  std::vector<Problem>& problems_;
  const JsonLimits& limits_;
  LineMap* wanted_;
  std::size_t at_ = 0, values_ = 0;
  int line_ = 1;
  std::string path_;
};

}  // namespace

Json read_json(std::string_view text, std::vector<Problem>& problems, const JsonLimits& limits) {
  if (text.size() > limits.bytes) {
    throw InputError("", {Problem{"", std::to_string(text.size()) + " bytes of text",
                                  "at most " + std::to_string(limits.bytes), 0}});
  }
  return Parser(text, problems, limits, nullptr).document();
}

Json read_json(std::string_view text, const std::string& file, std::vector<Problem>& problems) {
  try {
    return read_json(text, problems);
  } catch (const InputError& error) {
    throw InputError(file, error.problems());
  }
}

std::vector<int> json_lines(std::string_view text, std::span<const std::string> pointers) {
  LineMap lines;
  for (std::string pointer : pointers) {
    while (lines.emplace(pointer, 0).second && !pointer.empty()) pointer.resize(pointer.rfind('/'));
  }
  std::vector<Problem> ignored;
  const JsonLimits none{text.size(), text.size() + 1, std::numeric_limits<int>::max()};
  Parser(text, ignored, none, &lines).document();
  std::vector<int> result;
  for (std::string pointer : pointers) {
    while (lines.at(pointer) == 0 && !pointer.empty()) pointer.resize(pointer.rfind('/'));
    result.push_back(lines.at(pointer));
  }
  return result;
}

std::string describe(const Json& value) {
  switch (value.type()) {
    case Json::value_t::object:
      return value.empty() ? "{}" : "an object";
    case Json::value_t::array: {
      bool short_array = value.size() <= 4;
      std::string text = "[";
      for (std::size_t k = 0; short_array && k < value.size(); ++k) {
        short_array = !value[k].is_structured();
        text += (k ? ", " : "") + describe(value[k]);
      }
      return short_array ? text + ']' : "an array of " + std::to_string(value.size());
    }
    case Json::value_t::string:
      return quoted_excerpt(value.get_ref<const std::string&>());
    case Json::value_t::number_float:
      return number_text(value.get<double>());
    default:
      return value.dump();
  }
}

}  // namespace pf
