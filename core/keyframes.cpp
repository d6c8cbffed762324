#include "core/keyframes.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace pf {

void Keyframes::set_budget(std::size_t bytes) {
  budget_ = bytes;
  while (bytes_ > budget_ && !kept_.empty()) thin();
}

void Keyframes::clear() {
  kept_.clear();
  bytes_ = 0;
  interval_ = first_interval;
}

bool Keyframes::wants(long step) const {
  return budget_ > 0 && step % interval_ == 0 && (kept_.empty() || kept_.back().step < step);
}

void Keyframes::add(Keyframe keyframe) {
  while ((bytes_ + keyframe.state.size() > budget_ || kept_.size() >= most) && !kept_.empty()) thin();
  // What has no multiple of the interval left, or no room at all, is given up.
  if (keyframe.step % interval_ != 0 || keyframe.state.size() > budget_) return;
  bytes_ += keyframe.state.size();
  kept_.push_back(std::move(keyframe));
}

const Keyframe* Keyframes::before(long step) const {
  const auto after = std::partition_point(kept_.begin(), kept_.end(), [&](const Keyframe& k) { return k.step < step; });
  if (after != kept_.begin()) return &*std::prev(after);
  return step == 0 && !kept_.empty() && kept_.front().step == 0 ? &kept_.front() : nullptr;
}

void Keyframes::forget_after(long step) {
  while (!kept_.empty() && kept_.back().step > step) {
    bytes_ -= kept_.back().state.size();
    kept_.pop_back();
  }
}

void Keyframes::thin() {
  // One that is alone and has no room is given up, too.
  if (kept_.size() == 1) {
    kept_.clear();
    bytes_ = 0;
    return;
  }
  if (interval_ < std::numeric_limits<long>::max() / 2) interval_ *= 2;
  std::erase_if(kept_, [&](const Keyframe& k) {
    const bool gone = k.step % interval_ != 0;
    if (gone) bytes_ -= k.state.size();
    return gone;
  });
}

}  // namespace pf
