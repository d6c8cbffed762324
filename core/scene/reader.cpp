#include "core/scene/reader.hpp"

#include <cmath>
#include <utility>

#include "core/params/json_text.hpp"
#include "core/params/nearest.hpp"
#include "core/params/pointer.hpp"
#include "core/params/setting_text.hpp"

namespace pf {
namespace {

constexpr std::size_t most_problems = 100;
constexpr std::size_t longest_text = 10'000;

/// Compiles `text`; a problem and false where it is none.
bool compile(Reader& reader, const std::string& text, VariableMask mask, Expression& out) {
  try {
    out = Expression::compile(text, reader.constants(), mask);
    return true;
  } catch (const ExpressionError& error) {
    const std::string place = ", character " + std::to_string(error.position() + 1) + ": " + error.what();
    reader.refuse("the expression " + quoted_excerpt(text) + place, mask == mask_none
                                                                        ? "a number, or an expression of constants"
                                                                        : "expressions in " + variable_names(mask));
    return false;
  }
}

/// The number that `json` is or, as an expression of constants, gives. NaN after a problem.
double constant_value(Reader& reader, const Json& json, const std::string& allowed) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (json.is_number()) return json.get<double>();  // a NaN has been reported by read_json
  if (!json.is_string()) {
    reader.refuse(describe(json), allowed);
    return none;
  }
  Expression expression;
  if (!compile(reader, json.get<std::string>(), mask_none, expression)) return none;
  const double zeros[variable_count] = {};
  const double value = expression(zeros);
  if (!std::isfinite(value)) reader.refuse("an expression that is " + number_text(value), allowed);
  return std::isfinite(value) ? value : none;
}

/// Has the array one entry a component? If not, that is a problem.
bool check_components(Reader& reader, const Json& json, const Setting& setting) {
  const int n = reader.dimension();
  if (json.is_array() && json.size() == static_cast<std::size_t>(n)) return true;
  reader.refuse(describe(json), allowed_text(setting, n) + ", because \"dimension\" is " + std::to_string(n));
  return false;
}

Setting component_of(const Setting& setting, SettingKind kind) {
  Setting one = setting;
  one.kind = kind;
  return one;
}

}  // namespace

void Reader::refuse(std::string found, std::string allowed) {
  refuse("", std::move(found), std::move(allowed));
}

void Reader::refuse(std::string_view below, std::string found, std::string allowed) {
  if (++refused_ <= most_problems)
    problems_.push_back({path_ + std::string(below), std::move(found), std::move(allowed), 0});
}

std::vector<Problem> Reader::take_problems() {
  if (refused_ > most_problems) {
    problems_.push_back({"", std::to_string(refused_ - most_problems) + " more problems", "mend those above first", 0});
  }
  refused_ = 0;
  return std::exchange(problems_, {});
}

void Reader::take_from(Reader& other) {
  problems_.insert(problems_.end(), other.problems_.begin(), other.problems_.end());
  refused_ += other.refused_;
}

Reader::Step::Step(Reader& reader, std::string_view key) : reader_(reader), length_(reader.path_.size()) {
  reader_.path_ += pointer_step(key);
}
Reader::Step::Step(Reader& reader, std::size_t index) : reader_(reader), length_(reader.path_.size()) {
  reader_.path_ += '/' + std::to_string(index);
}

bool read_number(Reader& reader, const Json& json, const Setting& setting, double& out) {
  const std::string allowed = allowed_text(setting, 1);
  const double value = constant_value(reader, json, allowed);
  if (std::isnan(value)) return false;
  if (!in_range(setting, value)) {
    reader.refuse(json.is_string() ? describe(json) + " = " + number_text(value) : describe(json), allowed);
    return false;
  }
  out = value;
  return true;
}

bool read_integer(Reader& reader, const Json& json, const Setting& setting, std::uint64_t& out) {
  const std::string allowed = allowed_text(setting, 1);
  const double value = constant_value(reader, json, allowed);
  if (std::isnan(value)) return false;
  if (value != std::floor(value) || !in_range(setting, value)) {
    reader.refuse(describe(json), allowed);
    return false;
  }
  // Doubles hold whole numbers exactly only up to 2^53: take integers as they are written.
  out = json.is_number_unsigned() ? json.get<std::uint64_t>() : static_cast<std::uint64_t>(value);
  return true;
}

bool read_text(Reader& reader, const Json& json, const Setting& setting, std::string& out) {
  if (!json.is_string()) {
    reader.refuse(describe(json), allowed_text(setting, 1));
    return false;
  }
  const auto& text = json.get_ref<const std::string&>();
  if (text.size() > longest_text) {
    reader.refuse("a text of " + std::to_string(text.size()) + " bytes", "at most " + std::to_string(longest_text));
    return false;
  }
  if (text.empty() && setting.min > 0) {
    reader.refuse("an empty text", "a text of one character or more");
    return false;
  }
  out = text;
  return true;
}

bool read_flag(Reader& reader, const Json& json, bool& out) {
  if (json.is_boolean()) {
    out = json.get<bool>();
  } else {
    reader.refuse(describe(json), "true or false");
  }
  return json.is_boolean();
}

bool read_choice(Reader& reader, const Json& json, const Setting& setting, std::string& out) {
  if (json.is_string()) {
    const auto& text = json.get_ref<const std::string&>();
    for (const std::string& choice : setting.choices) {
      if (choice != text) continue;
      out = text;
      return true;
    }
    reader.refuse(describe(json), suggest(text, setting.choices));
  } else {
    reader.refuse(describe(json), suggest("", setting.choices));
  }
  return false;
}

bool read_vector(Reader& reader, const Json& json, const Setting& setting, Vec3& out) {
  if (!check_components(reader, json, setting)) return false;
  Vec3 value = Vec3::Zero();
  bool good = true;
  const Setting one = component_of(setting, SettingKind::number);
  for (int a = 0; a < reader.dimension(); ++a) {
    const Reader::Step step(reader, static_cast<std::size_t>(a));
    good = read_number(reader, json[static_cast<std::size_t>(a)], one, value[a]) && good;
  }
  if (good) out = value;
  return good;
}

bool read_flags(Reader& reader, const Json& json, const Setting& setting, std::vector<bool>& out) {
  if (!check_components(reader, json, setting)) return false;
  std::vector<bool> value;
  for (std::size_t a = 0; a < json.size(); ++a) {
    const Reader::Step step(reader, a);
    bool flag = false;
    if (read_flag(reader, json[a], flag)) value.push_back(flag);
  }
  if (value.size() != json.size()) return false;
  out = std::move(value);
  return true;
}

bool read_formula(Reader& reader, const Json& json, const Setting& setting, VariableMask mask, Formula& out) {
  const Setting one = component_of(setting, SettingKind::formula);
  if (json.is_string()) {
    Expression expression;
    const auto& text = json.get_ref<const std::string&>();
    if (!compile(reader, text, mask, expression)) return false;
    if (expression.is_constant()) {
      const double zeros[variable_count] = {};
      const double value = expression(zeros);
      if (!in_range(one, value)) {
        reader.refuse(describe(json) + " = " + number_text(value), allowed_text(one, 1));
        return false;
      }
    }
    out = {0, text};
    return true;
  }
  if (!json.is_number()) {
    reader.refuse(describe(json), allowed_text(one, 1) + " (in " + variable_names(mask) + ")");
    return false;
  }
  out.text.clear();
  return read_number(reader, json, one, out.number);
}

bool read_formulas(Reader& reader, const Json& json, const Setting& setting, VariableMask mask, FormulaVector& out) {
  if (!check_components(reader, json, setting)) return false;
  FormulaVector value(json.size());
  bool good = true;
  for (std::size_t a = 0; a < json.size(); ++a) {
    const Reader::Step step(reader, a);
    good = read_formula(reader, json[a], setting, mask, value[a]) && good;
  }
  if (good) out = std::move(value);
  return good;
}

bool check_count(Reader& reader, std::size_t count, std::size_t most, std::string_view what) {
  if (count > most) {
    reader.refuse(std::to_string(count) + " " + std::string(what), "at most " + std::to_string(most));
  }
  return count <= most;
}

std::string variable_names(VariableMask mask) {
  std::string text;
  for (int v = 0; v < variable_count; ++v) {
    if (mask >> v & 1u) text += (text.empty() ? "" : " ") + std::string(all_variables[v]);
  }
  return text;
}

}  // namespace pf
