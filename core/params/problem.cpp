#include "core/params/problem.hpp"

#include <utility>

namespace pf {
namespace {

std::string message(const std::string& file, const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    if (!text.empty()) text += '\n';
    if (!file.empty()) text += file + ": ";
    text += to_string(problem);
  }
  return text;
}

}  // namespace

std::string to_string(const Problem& problem) {
  std::string text = problem.pointer.empty() ? "the document" : problem.pointer;
  if (problem.line > 0) text += ", line " + std::to_string(problem.line);
  text += ": found " + problem.found;
  if (!problem.allowed.empty()) text += "; allowed: " + problem.allowed;
  return text;
}

InputError::InputError(std::string file, std::vector<Problem> problems)
    : std::runtime_error(message(file, problems)), file_(std::move(file)), problems_(std::move(problems)) {}

}  // namespace pf
