// Reading JSON into values: every problem is collected with its pointer, nothing is thrown.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/math/expression.hpp"
#include "core/params/json_reader.hpp"
#include "core/params/setting.hpp"
#include "core/scene/scene.hpp"

namespace pf {

/// Where reading is, what it may use, and what was wrong so far.
class Reader {
 public:
  Reader(int dimension, Constants constants) : dimension_(dimension), constants_(std::move(constants)) {}

  int dimension() const { return dimension_; }
  const Constants& constants() const { return constants_; }
  const std::string& pointer() const { return path_; }

  /// A problem at the present pointer. Beyond the first hundred they are only counted.
  void refuse(std::string found, std::string allowed);
  /// A problem below the present pointer: `below` begins with '/'.
  void refuse(std::string_view below, std::string found, std::string allowed);
  std::size_t refused() const { return refused_; }
  std::vector<Problem> take_problems();
  /// Takes over the problems of another reader.
  void take_from(Reader& other);

  /// While it lives, the reader is one step further down.
  class Step {
   public:
    Step(Reader& reader, std::string_view key);
    Step(Reader& reader, std::size_t index);
    ~Step() { reader_.path_.resize(length_); }
    Step(const Step&) = delete;
    Step& operator=(const Step&) = delete;

   private:
    Reader& reader_;
    std::size_t length_;
  };

 private:
  int dimension_;
  Constants constants_;
  std::string path_;
  std::vector<Problem> problems_;
  std::size_t refused_ = 0;
};

// Leaves. Each returns whether `out` has been set; if not, why is among the problems. Numbers may be given as
// expressions of constants (INTERFACE fine print 1): "1/60".
bool read_number(Reader& reader, const Json& json, const Setting& setting, double& out);
bool read_integer(Reader& reader, const Json& json, const Setting& setting, std::uint64_t& out);
bool read_text(Reader& reader, const Json& json, const Setting& setting, std::string& out);
bool read_flag(Reader& reader, const Json& json, bool& out);
bool read_choice(Reader& reader, const Json& json, const Setting& setting, std::string& out);
bool read_vector(Reader& reader, const Json& json, const Setting& setting, Vec3& out);
bool read_flags(Reader& reader, const Json& json, const Setting& setting, std::vector<bool>& out);
/// `mask`: the variables that the expression may use; `names` says them in messages.
bool read_formula(Reader& reader, const Json& json, const Setting& setting, VariableMask mask, Formula& out);
bool read_formulas(Reader& reader, const Json& json, const Setting& setting, VariableMask mask, FormulaVector& out);

/// Shorter than `most`? If not, that is a problem.
bool check_count(Reader& reader, std::size_t count, std::size_t most, std::string_view what);
/// "X Y Z t"
std::string variable_names(VariableMask mask);

}  // namespace pf
