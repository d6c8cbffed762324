// pushforward compare: two run folders, field by field and in time.
#include <algorithm>
#include <cstdio>

#include "app/cli/commands.hpp"
#include "core/output/compare.hpp"

namespace pf::app {

int compare_folders(const CompareOptions& options) {
  const Comparison comparison = compare_runs(options.a, options.b);
  std::size_t width = 5;
  for (const FieldDifference& field : comparison.fields)
    width = std::max(width, field.file.size() + field.field.size() + 1);
  std::printf("%-*s  %12s  %12s  %12s  %10s\n", static_cast<int>(width), "field", "relative", "largest", "rms",
              "at t [s]");
  for (const bool judged : {true, false})
    for (const FieldDifference& field : comparison.fields) {
      if (field.judged != judged) continue;
      const std::string name = field.file + " " + field.field;
      std::printf("%-*s  %12.4g  %12.4g  %12.4g  %10.4g%s\n", static_cast<int>(width), name.c_str(), field.relative(),
                  field.largest, field.rms, field.time, judged ? "" : "  (not judged)");
    }
  for (const std::string& note : comparison.notes) std::printf("note: %s\n", note.c_str());
  const double worst = comparison.worst();
  const bool above = !(worst <= options.tolerance);
  std::printf("largest relative difference %.4g: %s the tolerance %.4g\n", worst, above ? "above" : "within",
              options.tolerance);
  return above ? exit_comparison_failed : exit_done;
}

}  // namespace pf::app
