// Work as one number: particle visits are counted by kernel as a step goes (StepReport::work) and added up with what a
// visit of each kernel costs. A cost that no clock disturbs: studies compare methods by it, and adaptive step control
// decides by it.
#pragma once

#include <span>
#include <string_view>

#include "core/step_report.hpp"

namespace pf {

/// What one visit costs [ns on the machine of measurement], by dimension and nodes an axis of the basis.
struct KernelWeight {
  std::string_view kernel;  ///< a member of Work, as studies name it without "visits_"
  std::uint64_t Work::*visits;
  double two[3], three[3];  ///< 2D and 3D; 2, 3 and 4 nodes an axis: linear, quadratic, cubic
};

std::span<const KernelWeight> kernel_weights();
/// Where the numbers come from, for people.
std::string_view kernel_weights_note();
Work& operator+=(Work& work, const Work& more);
/// The weighted sum of the visits, in units of one 2D quadratic Hessian product of one particle.
double weighted_work(const Work& work, int dimension, int nodes_per_axis);

}  // namespace pf
