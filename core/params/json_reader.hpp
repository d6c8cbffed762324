// JSON as people write it by hand, read strictly: `//` comments are allowed; duplicate keys, invalid UTF-8,
// numbers beyond double and everything that is not JSON are refused, with the place.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/params/problem.hpp"

namespace pf {

/// Keeps the order of keys in the file.
using Json = nlohmann::ordered_json;

/// What is refused before it costs memory or time.
struct JsonLimits {
  std::size_t bytes = std::size_t{16} << 20;  ///< of text
  std::size_t values = 1'000'000;             ///< numbers, strings, objects, ... together
  int depth = 100;                            ///< of brackets
};

/// The value of `text`. What makes it no JSON at all is thrown as InputError (its file() is empty); duplicate
/// keys and numbers too large for double are added to `problems`, and reading goes on: of duplicates the first
/// counts, such a number becomes a NaN.
Json read_json(std::string_view text, std::vector<Problem>& problems, const JsonLimits& limits = {});
/// The same; an InputError names `file`.
Json read_json(std::string_view text, const std::string& file, std::vector<Problem>& problems);

/// The line (from 1) on which the value that each pointer names begins; its nearest existing ancestor's when it
/// is not there. `text` has been read by read_json.
std::vector<int> json_lines(std::string_view text, std::span<const std::string> pointers);

/// "3", "\"abc\"", "an object", "an array of 4": a value in a message, never long.
std::string describe(const Json& value);

}  // namespace pf
