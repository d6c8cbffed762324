// The friction of the last step, from which the next one's iteration begins.
#include <algorithm>

#include "core/step/simulation_of.hpp"

namespace pf {

template <int D>
void SimulationOf<D>::guess_friction(FeasibleSet<D>& set) const {
  if (rubbing_.empty()) return;
  for (NodeConstraint<D>& c : set.constrained) {
    if (!(c.friction > 0)) continue;
    const std::array<long long, D>& index = plan_.node_index(c.node);
    const auto last = std::lower_bound(rubbing_.begin(), rubbing_.end(), index,
                                       [](const RubbingNode<D>& r, const auto& i) { return r.index < i; });
    if (last == rubbing_.end() || last->index != index) continue;
    for (int k = 0; k < c.faces; ++k)
      if (c.normal[static_cast<std::size_t>(k)].dot(last->normal) > 0.99) {
        c.rub_normal = c.normal[static_cast<std::size_t>(k)];
        c.rub_bound = last->bound;
      }
  }
}

template <int D>
void SimulationOf<D>::keep_friction(const FeasibleSet<D>& set) {
  rubbing_.clear();
  for (const NodeConstraint<D>& c : set.constrained)
    if (c.rub_bound > 0) rubbing_.push_back({plan_.node_index(c.node), c.rub_normal, c.rub_bound});
  std::sort(rubbing_.begin(), rubbing_.end(), [](const auto& a, const auto& b) { return a.index < b.index; });
}

#define PF_INSTANTIATE(D)                                               \
  template void SimulationOf<D>::guess_friction(FeasibleSet<D>&) const; \
  template void SimulationOf<D>::keep_friction(const FeasibleSet<D>&);
PF_INSTANTIATE(2)
PF_INSTANTIATE(3)
#undef PF_INSTANTIATE

}  // namespace pf
