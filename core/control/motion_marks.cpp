#include "core/control/motion_marks.hpp"

#include <cmath>

namespace pf {

void MotionMarks::add(double time, std::span<const double> x) {
  constexpr std::size_t most = 4;
  if (!marks_.empty() && marks_.front().x.size() != x.size()) clear();
  if (marks_.size() == most) marks_.erase(marks_.begin());
  marks_.push_back({time, {x.begin(), x.end()}});
  acceleration_ = jerk_ = 0;
  const std::size_t n = marks_.size();
  if (n < 3 || x.empty()) return;
  // Newton's divided differences: x'' / 2 of three marks, x''' / 6 of four.
  double second = 0, third = 0;
  const auto slope = [&](std::size_t k, std::size_t i) {
    return (marks_[k + 1].x[i] - marks_[k].x[i]) / (marks_[k + 1].time - marks_[k].time);
  };
  const auto bend = [&](std::size_t k, std::size_t i) {
    return (slope(k + 1, i) - slope(k, i)) / (marks_[k + 2].time - marks_[k].time);
  };
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double newest = bend(n - 3, i);
    second += newest * newest;
    if (n < most) continue;
    const double change = (newest - bend(0, i)) / (marks_[3].time - marks_[0].time);
    third += change * change;
  }
  const double points = static_cast<double>(x.size()) / dimension_;
  acceleration_ = 2 * std::sqrt(second / points);
  jerk_ = 6 * std::sqrt(third / points);
}

void MotionMarks::save(std::vector<double>& to) const {
  to.push_back(static_cast<double>(marks_.size()));
  to.push_back(marks_.empty() ? 0 : static_cast<double>(marks_.front().x.size()));
  to.push_back(acceleration_);
  to.push_back(jerk_);
  for (const Mark& mark : marks_) {
    to.push_back(mark.time);
    to.insert(to.end(), mark.x.begin(), mark.x.end());
  }
}

bool MotionMarks::load(std::span<const double>& from) {
  if (from.size() < 4) return false;
  const double count = from[0], size = from[1];
  const double left = static_cast<double>(from.size()) - 4;
  if (!(count >= 0 && count <= 4) || !(size >= 0) || !(count * (size + 1) <= left)) return false;
  MotionMarks loaded(dimension_);
  loaded.acceleration_ = from[2];
  loaded.jerk_ = from[3];
  from = from.subspan(4);
  const auto length = static_cast<std::size_t>(size);
  for (int k = 0; k < static_cast<int>(count); ++k) {
    const auto x = from.subspan(1, length);
    loaded.marks_.push_back({from[0], {x.begin(), x.end()}});
    from = from.subspan(1 + length);
  }
  *this = std::move(loaded);
  return true;
}

}  // namespace pf
