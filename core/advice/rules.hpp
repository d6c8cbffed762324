// What an advisor tries. A new rule: one function and one line in the table of rules.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.hpp"

namespace pf {

/// What rules know of the run.
struct AdviceFacts {
  const Scene& scene;
  double step = 0;            ///< of the run as it is [s]
  double explicit_limit = 0;  ///< the longest stable explicit step from the state at hand [s]
  double largest_strain = 0;  ///< max |F - I| (Frobenius) over the particles
};

/// Settings to be tried. They apply live; where they do not go with the scene the trial is left out.
struct Proposal {
  std::string title;
  std::vector<Edit> edits;
};

struct AdviceRule {
  std::string_view name;
  std::string_view sentence;  ///< what to do; {} stands for the title of the proposal
  std::vector<Proposal> (*propose)(const AdviceFacts& facts);
};
std::span<const AdviceRule> advice_rules();

/// How far trials go, in steps of the run as it is: a whole number of the longest steps that any rule tries, and long
/// enough for waves to cross some cells, within reason: over a few very short steps the step decides all errors.
int trial_steps(const AdviceFacts& facts);
/// The basis on the same nodes by whose answer the grid is judged.
std::string_view other_basis(std::string_view basis);

}  // namespace pf
