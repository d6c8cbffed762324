// What lessons measure of a run, by name: conditions and numbers in their texts are expressions of these.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/bases/basis.hpp"
#include "core/math/expression.hpp"
#include "core/scene/scene.hpp"
#include "core/snapshot.hpp"

namespace pf::app {

/// Measures of one run, grown report by report.
class RunMeasures {
 public:
  void begin() { *this = {}; }
  void add(const StepReport& report);
  std::size_t size() const { return count_; }
  /// All measures as constants of an expression. `snapshot` may be null: what needs one is left out then.
  Constants values(const Scene& scene, const Snapshot* snapshot) const;

 private:
  std::size_t count_ = 0;
  StepReport first_, last_;
  double most_newton_ = 0, sum_newton_ = 0, sum_linear_ = 0, most_error_ = 0, most_total_ = -1e300, least_J_ = 1,
         retries_ = 0, visits_ = 0, lost_transfer_ = 0, lost_time_ = 0, lost_outside_ = 0, order_ = 0,
         most_kinetic_ = 0;
};

struct MeasureInfo {
  const char *name, *about;
};
/// Every measure, in the order of values().
std::span<const MeasureInfo> measure_infos();

/// Whether an expression speaks of measures that need a snapshot.
bool needs_snapshot(std::string_view expression);
/// The value of an expression of measures; throws ExpressionError.
double measured(std::string_view expression, const Constants& values);
/// `text` with each {expression|unit} replaced by its value; throws ExpressionError.
std::string with_values(std::string_view text, const Constants& values);

/// Number of separate pieces: particles belong together where they share a node.
int count_pieces(const Snapshot& snapshot, const BasisInfo& basis);

}  // namespace pf::app
