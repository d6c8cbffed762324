#include "core/grid/ghost_penalty.hpp"

#include <algorithm>
#include <cmath>

namespace pf {

namespace {

constexpr std::array<double, 4> difference{-1, 3, -3, 1};

std::size_t at(std::int32_t i) {
  return static_cast<std::size_t>(i);
}

/// Does the line of four from this coordinate on meet a spline that ends at a wall?
bool meets(const EdgePlanes& walls, long long from) {
  constexpr long long reach = 1;  // the functions on both sides of the plane are not splines
  const auto near = [&](const std::optional<long long>& plane) {
    return plane && from <= *plane + reach && from + 3 >= *plane - reach;
  };
  return near(walls.low) || near(walls.high);
}

}  // namespace

template <int D>
void GhostPenalty<D>::find_full(const Plan<D>& plan, const Vector& lumped) {
  full_ = lumped;
  for (std::size_t a = 0; a < D; ++a) {
    std::vector<std::int32_t>& next = next_[a];
    next.resize(static_cast<std::size_t>(plan.node_count()));
    for (std::size_t i = 0; i < next.size(); ++i) {
      std::array<long long, D> index = plan.node_indices()[i];
      ++index[a];
      next[i] = plan.find_node(index);
    }
    // Axis after axis: the heaviest of a box.
    spread_ = full_;
    for (std::size_t i = 0; i < next.size(); ++i) {
      const auto here = static_cast<Eigen::Index>(i);
      std::int32_t other = next[i];
      for (int step = 0; step < 3 && other >= 0; ++step, other = next[at(other)]) {
        spread_[here] = std::max(spread_[here], full_[other]);
        spread_[other] = std::max(spread_[other], full_[here]);
      }
    }
    full_.swap(spread_);
  }
}

template <int D>
void GhostPenalty<D>::build(const Plan<D>& plan, const Vector& lumped, double gamma) {
  lines_.clear();
  find_full(plan, lumped);
  for (int axis = 0; axis < D; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const std::vector<std::int32_t>& next = next_[a];
    for (std::size_t i = 0; i < next.size(); ++i) {
      if (meets(plan.edges(axis), plan.node_indices()[i][a])) continue;
      Line line{{static_cast<std::int32_t>(i), -1, -1, -1}, 0};
      bool any_light = false, whole = true;
      for (std::size_t k = 0; k < 4 && whole; ++k) {
        if (k > 0) line.node[k] = next[at(line.node[k - 1])];
        whole = line.node[k] >= 0;
        if (!whole) break;
        any_light = any_light || lumped[line.node[k]] < light * full_[line.node[k]];
        line.strength = std::max(line.strength, gamma * full_[line.node[k]]);
      }
      if (whole && any_light) lines_.push_back(line);
    }
  }
}

template <int D>
void GhostPenalty<D>::add_product(const Vector& v, Vector& out) const {
  for (const Line& line : lines_) {
    Vec<D> jump = Vec<D>::Zero();
    for (std::size_t k = 0; k < 4; ++k)
      jump += difference[k] * v.segment<D>(static_cast<Eigen::Index>(line.node[k]) * D);
    jump *= line.strength;
    for (std::size_t k = 0; k < 4; ++k)
      out.segment<D>(static_cast<Eigen::Index>(line.node[k]) * D) += difference[k] * jump;
  }
}

template <int D>
void GhostPenalty<D>::add_diagonal(Vector& diagonal) const {
  for (const Line& line : lines_)
    for (std::size_t k = 0; k < 4; ++k) diagonal[line.node[k]] += line.strength * difference[k] * difference[k];
}

template <int D>
void GhostPenalty<D>::pairs(const std::function<void(std::int32_t, std::int32_t)>& add) const {
  for (const Line& line : lines_)
    for (std::size_t r = 0; r < 4; ++r)
      for (std::size_t c = 0; c <= r; ++c)
        add(std::max(line.node[r], line.node[c]), std::min(line.node[r], line.node[c]));
}

template <int D>
void GhostPenalty<D>::assemble(double factor, BlockMatrix<D>& H) const {
  for (const Line& line : lines_)
    for (std::size_t r = 0; r < 4; ++r)
      for (std::size_t c = 0; c <= r; ++c) {
        const double value = factor * line.strength * difference[r] * difference[c];
        const std::int32_t i = line.node[r], j = line.node[c];
        H.at(std::max(i, j), std::min(i, j)).diagonal().array() += value;
      }
}

template class GhostPenalty<2>;
template class GhostPenalty<3>;

}  // namespace pf
