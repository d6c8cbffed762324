#include "core/params/pointer.hpp"

#include <charconv>

namespace pf {

std::string pointer_step(std::string_view key) {
  std::string step = "/";
  for (const char c : key) {
    if (c == '~') {
      step += "~0";
    } else if (c == '/') {
      step += "~1";
    } else {
      step += c;
    }
  }
  return step;
}

std::optional<std::vector<std::string>> split_pointer(std::string_view pointer) {
  std::vector<std::string> steps;
  if (pointer.empty()) return steps;
  if (pointer[0] != '/') return std::nullopt;
  for (std::size_t k = 0; k < pointer.size(); ++k) {
    if (pointer[k] == '/') {
      steps.emplace_back();
    } else if (pointer[k] == '~') {
      const char next = k + 1 < pointer.size() ? pointer[k + 1] : '\0';
      if (next != '0' && next != '1') return std::nullopt;
      steps.back() += next == '0' ? '~' : '/';
      ++k;
    } else {
      steps.back() += pointer[k];
    }
  }
  return steps;
}

std::optional<std::size_t> array_index(std::string_view step) {
  if (step.empty() || (step[0] == '0' && step.size() > 1)) return std::nullopt;
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(step.data(), step.data() + step.size(), index);
  if (error != std::errc() || end != step.data() + step.size()) return std::nullopt;
  return index;
}

bool is_at_or_below(std::string_view pointer, std::string_view ancestor) {
  return pointer.starts_with(ancestor) && (pointer.size() == ancestor.size() || pointer[ancestor.size()] == '/');
}

}  // namespace pf
