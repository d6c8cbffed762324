// The nearest known name, for "did you mean".
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace pf {

/// The candidate with the fewest insertions, deletions, replacements and swaps of neighbours from `name`; "" when
/// none is near (more than a third of the longer name's letters differ, at least 2 are let pass).
std::string nearest_name(std::string_view name, std::span<const std::string> candidates);
/// "one of a, b, c"; with `name` near one of them, its suggestion first: "\"basis\"? One of ...".
std::string suggest(std::string_view name, std::span<const std::string> candidates);

}  // namespace pf
