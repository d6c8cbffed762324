// How the motion bends, from the bodies' places at some times some steps apart: waves shorter than the interval average
// out, which no quantity of a single explicit step can do.
#pragma once

#include <span>
#include <vector>

namespace pf {

class MotionMarks {
 public:
  /// Of points with so many components each.
  explicit MotionMarks(int dimension = 2) : dimension_(dimension) {}
  /// The places at `time`, always in the same order. The oldest of four marks is forgotten.
  void add(double time, std::span<const double> x);
  void clear() { marks_.clear(); }
  std::size_t count() const { return marks_.size(); }

  /// Root mean squares over the points of the second and third derivative of the newest marks: mean acceleration
  /// [m/s^2] and its rate [m/s^3], where places are in metres. Zero before there are three, four marks.
  double acceleration() const { return acceleration_; }
  double jerk() const { return jerk_; }

  void save(std::vector<double>& to) const;
  /// Takes what save() wrote off the front of `from`; false where it is not that.
  bool load(std::span<const double>& from);

 private:
  struct Mark {
    double time;
    std::vector<double> x;
  };
  int dimension_;
  std::vector<Mark> marks_;  ///< oldest first
  double acceleration_ = 0, jerk_ = 0;
};

}  // namespace pf
