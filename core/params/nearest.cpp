#include "core/params/nearest.hpp"

#include <algorithm>
#include <vector>

namespace pf {
namespace {

/// Optimal string alignment distance.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) now[j] = std::min(now[j], before[j - 2] + 1);
    }
    before = last;
    last = now;
  }
  return last[b.size()];
}

}  // namespace

std::string nearest_name(std::string_view name, std::span<const std::string> candidates) {
  if (name.size() > 64) return "";
  std::string best;
  std::size_t least = 0;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(name, candidate);
    if (distance > std::max<std::size_t>(2, std::max(name.size(), candidate.size()) / 3)) continue;
    if (distance >= std::max(name.size(), candidate.size())) continue;  // nothing in common
    if (best.empty() || distance < least) {
      best = candidate;
      least = distance;
    }
  }
  return best;
}

std::string suggest(std::string_view name, std::span<const std::string> candidates) {
  if (candidates.empty()) return "nothing";
  const std::string near = nearest_name(name, candidates);
  std::string text;
  if (!near.empty() && candidates.size() > 1) text = "\"" + near + "\" (did you mean that?), or ";
  text += candidates.size() == 1 ? "only " : "one of ";
  const std::size_t shown = std::min<std::size_t>(candidates.size(), 60);
  for (std::size_t k = 0; k < shown; ++k) text += (k ? ", " : "") + candidates[k];
  if (shown < candidates.size()) text += ", ...";
  return text;
}

}  // namespace pf
