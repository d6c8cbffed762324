// Snapshots whose buffers come back when the last reader lets go, so that publishing allocates nothing in the
// steady state.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "core/snapshot.hpp"

namespace pf::app {

class SnapshotPool {
 public:
  /// A snapshot to fill, with the buffers of one that nobody reads any more, if there is one; its arrays are empty.
  std::shared_ptr<Snapshot> take() {
    std::unique_ptr<Snapshot> snapshot;
    {
      const std::lock_guard lock(shelf_->mutex);
      if (!shelf_->idle.empty()) {
        snapshot = std::move(shelf_->idle.back());
        shelf_->idle.pop_back();
      }
    }
    if (!snapshot) snapshot = std::make_unique<Snapshot>();
    empty(*snapshot);
    // The deleter owns the shelf too: a reader may outlive the pool.
    return {snapshot.release(), [shelf = shelf_](Snapshot* returned) {
              std::unique_ptr<Snapshot> owned(returned);
              const std::lock_guard lock(shelf->mutex);
              if (shelf->idle.size() < most_idle) shelf->idle.push_back(std::move(owned));
            }};
  }

 private:
  /// Sizes 0, capacities kept: what nobody asked for this time must not show last time's values.
  static void empty(Snapshot& snapshot) {
    snapshot.particles = snapshot.nodes = 0;
    snapshot.v.clear();
    snapshot.stress.clear();
    for (auto& values : snapshot.field) values.clear();
    snapshot.node_index.clear();
    snapshot.node_mass.clear();
    snapshot.node_velocity.clear();
    snapshot.node_displacement.clear();
    snapshot.node_state.clear();
    snapshot.grabbed = false;
  }
  static constexpr std::size_t most_idle = 3;  // one shown, one published, one being filled
  struct Shelf {
    std::mutex mutex;
    std::vector<std::unique_ptr<Snapshot>> idle;
  };
  std::shared_ptr<Shelf> shelf_ = std::make_shared<Shelf>();
};

}  // namespace pf::app
