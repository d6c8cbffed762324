// JSON pointers (RFC 6901) as texts and as steps.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pf {

/// "/" and the key, with ~ and / escaped.
std::string pointer_step(std::string_view key);
/// The unescaped keys of a pointer; nothing when it neither is empty nor begins with '/', or an escape is wrong.
std::optional<std::vector<std::string>> split_pointer(std::string_view pointer);
/// The index that an array step names: digits without leading zeros.
std::optional<std::size_t> array_index(std::string_view step);
/// Is `pointer` equal to `ancestor` or below it?
bool is_at_or_below(std::string_view pointer, std::string_view ancestor);

}  // namespace pf
