// pushforward chart: columns of CSV files as a picture.
#include <cstdio>

#include "app/cli/commands.hpp"
#include "core/charts/draw.hpp"
#include "core/charts/theme.hpp"
#include "core/params/problem.hpp"

namespace pf::app {

int chart_tables(const ChartOptions& options) {
  const std::string format = options.out.extension().string();
  if (format != ".svg" && format != ".png" && format != ".csv")
    throw InputError("--out", {{"", options.out.string(), "a file that ends in .svg, .png or .csv"}});
  const Chart chart = table_chart(options.chart);
  const ChartTheme theme = options.dark ? dark_theme() : light_theme();
  const ImageText text{{"Software", "pushforward " + version_text()}};
  const auto [width, height] = options.size;
  if (format == ".svg") write_chart_svg(chart, theme, width, height, options.out, text);
  if (format == ".png") write_chart_png(chart, theme, width, height, options.out, 2, text);
  if (format == ".csv") write_chart_csv(chart, options.out);
  return exit_done;
}

}  // namespace pf::app
