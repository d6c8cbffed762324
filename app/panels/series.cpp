#include "app/panels/series.hpp"

#include "app/widgets/units.hpp"

namespace pf::app {

Chart time_chart(const std::string& title, const std::string& unit) {
  Chart chart;
  chart.x.title = "Time";
  chart.x.unit = "s";
  chart.y.title = title;
  chart.y.unit = unit;
  return chart;
}

void add_series(Chart& chart, const std::string& label, const std::vector<double>& x, const std::vector<double>& y,
                std::size_t color, Role role, bool dashed) {
  constexpr std::size_t enough = 4000;
  Series series;
  series.label = label;
  series.x = x;
  series.y = y;
  thin(series.x, series.y, enough);
  if (role == Role::current) series.color_index = color;  // pinned ones are grey
  series.pinned = role == Role::pinned;
  series.dashed = dashed;
  chart.series.push_back(std::move(series));
}

std::string newest(const std::vector<double>& values, std::string_view unit) {
  return values.empty() ? std::string() : quantity(values.back(), unit, 4);
}

}  // namespace pf::app
