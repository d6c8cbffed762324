// Work: a cost that no clock disturbs. Particle visits are counted by kernel as a run goes (StepReport::work) and added
// up with what a visit of each kernel costs.
#pragma once

#include <span>
#include <string_view>

#include "core/studies/row.hpp"

namespace pf {

/// What one visit costs [ns on the machine of measurement], by dimension and nodes an axis of the basis.
struct KernelWeight {
  std::string_view kernel;  ///< as in row_columns, without "visits_"
  double StudyRow::*visits;
  double two[3], three[3];  ///< 2D and 3D; 2, 3 and 4 nodes an axis: linear, quadratic, cubic
};

std::span<const KernelWeight> kernel_weights();
/// Where the numbers come from, for people.
std::string_view kernel_weights_note();
/// The weighted sum of a row's visits, in units of one 2D quadratic Hessian product of one particle.
double weighted_work(const StudyRow& row, int dimension, int nodes_per_axis);

}  // namespace pf
