#include "core/studies/probe_track.hpp"

namespace pf {

void ProbeTrack::add(double time, const Vec3& x) {
  times_.push_back(time);
  places_.push_back(x);
}

void ProbeTrack::fill(StudyRow& row) const {
  if (places_.empty()) return;
  const Vec3 u = places_.back() - places_.front();
  row.probe_ux = u.x();
  row.probe_uy = u.y();
  row.probe_uz = u.z();
  // Along the axis of the largest swing; from one upward passage through its middle to the last.
  Vec3 low = places_[0], high = places_[0];
  for (const Vec3& x : places_) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  Eigen::Index axis = 0;
  if (!((high - low).maxCoeff(&axis) > 0)) return;
  const double middle = 0.5 * (low[axis] + high[axis]);
  double first = 0, last = 0;
  int passages = 0;
  for (std::size_t k = 1; k < places_.size(); ++k) {
    const double before = places_[k - 1][axis] - middle, after = places_[k][axis] - middle;
    if (!(before < 0 && after >= 0)) continue;
    last = times_[k - 1] + (times_[k] - times_[k - 1]) * before / (before - after);
    if (passages++ == 0) first = last;
  }
  if (passages > 1) row.probe_period = (last - first) / (passages - 1);
}

}  // namespace pf
