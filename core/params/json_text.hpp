// Texts and numbers as they stand in files and messages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace pf {

/// Bytes of the UTF-8 character at the front of `text`; 0 when there is none (overlong forms, surrogates and codes
/// beyond U+10FFFF are none).
std::size_t utf8_length(std::string_view text);
void append_utf8(std::string& text, std::uint32_t code);

/// The beginning of `text` in double quotes, on one line, printable, cut after 40 bytes or so.
std::string quoted_excerpt(std::string_view text);

/// The shortest digits that give back exactly `value`, as people write it: 0.01, 1000, 1e-6, 2.5e9.
std::string number_text(double value);

}  // namespace pf
