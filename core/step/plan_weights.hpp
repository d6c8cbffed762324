// One particle's weights out of a plan, for those who look: the numbers that transfers use, averaged over its domain
// and ended at walls where the plan's are.
#pragma once

#include <vector>

#include "core/grid/plan.hpp"
#include "core/look.hpp"

namespace pf {

/// The nodes of the particle's stencil, x fastest, K^D of them, with w_ip and grad w_ip [1/m]. `particle`: its place in
/// the arrays that the plan was made of (not its id), less than their size.
template <int D>
std::vector<NodeWeight> weights_in(const Plan<D>& plan, std::size_t particle);

extern template std::vector<NodeWeight> weights_in<2>(const Plan<2>&, std::size_t);
extern template std::vector<NodeWeight> weights_in<3>(const Plan<3>&, std::size_t);

}  // namespace pf
