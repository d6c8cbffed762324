// Whether constraints and walls hold what a quasi-static step must hold (THEORY T7).
#pragma once

#include <string>

#include "core/grid/plan.hpp"
#include "core/solvers/feasible_set.hpp"

namespace pf {

/// What is free to move as a rigid body, for the user; empty where every connected part of the grid is held against
/// moving and, to first order, against turning. A face that only pushes counts as holding along its normal, and with
/// friction along itself: a load that pulls a body off it leaves Newton's method without a minimum to find.
template <int D>
std::string free_rigid_motion(const Plan<D>& plan, const FeasibleSet<D>& set);

extern template std::string free_rigid_motion<2>(const Plan<2>&, const FeasibleSet<2>&);
extern template std::string free_rigid_motion<3>(const Plan<3>&, const FeasibleSet<3>&);

}  // namespace pf
