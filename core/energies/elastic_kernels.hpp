// What the parts of the elastic energy share.
#pragma once

#include "core/grid/stencil.hpp"

namespace pf {

inline std::size_t index(std::int32_t i) {
  return static_cast<std::size_t>(i);
}

/// Some batches of a block at a deformed state, few enough to stay in a first-level cache.
template <int D>
struct ElasticChunk {
  static constexpr int most_batches = 128 / lane_count<D>, most = most_batches * lane_count<D>;
  int batch_begin, batch_end;  ///< of the plan
  int begin, end;              ///< particles
  Mat<D> F[most], P[most];
  double psi[most];
};

/// body(chunk) for consecutive pieces of a block.
template <int D, class Body>
void for_each_chunk(const Plan<D>& plan, const Block<D>& block, Body&& body) {
  ElasticChunk<D> chunk;
  for (int i = block.batch_begin; i < block.batch_end; i = chunk.batch_end) {
    chunk.batch_begin = i;
    chunk.batch_end = std::min(block.batch_end, i + ElasticChunk<D>::most_batches);
    const Batch& last = plan.batches()[index(chunk.batch_end - 1)];
    chunk.begin = plan.batches()[index(i)].first;
    chunk.end = last.first + last.count;
    body(chunk);
  }
}

/// body(material, first, count) for the particles [begin, end) of a block, material by material.
template <int D, class Body>
void for_each_material(const Plan<D>& plan, const Block<D>& block, int begin, int end, Body&& body) {
  for (int r = block.run_begin; r < block.run_end; ++r) {
    const MaterialRun& run = plan.runs()[index(r)];
    const int first = std::max(begin, run.begin), last = std::min(end, run.end);
    if (first < last) body(run.material, first, index(last - first));
  }
}

}  // namespace pf
