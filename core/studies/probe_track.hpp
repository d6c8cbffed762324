// The first probe's motion: how far it gets, and how long it takes to swing once.
#pragma once

#include "core/studies/row.hpp"
#include "core/types.hpp"

namespace pf {

class ProbeTrack {
 public:
  void add(double time, const Vec3& x);
  /// StudyRow::probe_*; nothing where no place was added.
  void fill(StudyRow& row) const;

 private:
  std::vector<double> times_;
  std::vector<Vec3> places_;
};

}  // namespace pf
