// What the plots over time have in common.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/panels/runs.hpp"
#include "core/charts/chart.hpp"

namespace pf::app {

enum class Role { current, pinned };

/// An empty chart over time.
Chart time_chart(const std::string& title, const std::string& unit);
/// Adds a curve, thinned to what a screen can show.
void add_series(Chart& chart, const std::string& label, const std::vector<double>& x, const std::vector<double>& y,
                std::size_t color, Role role, bool dashed = false);
/// The last value with its unit, "" before the first.
std::string newest(const std::vector<double>& values, std::string_view unit);

}  // namespace pf::app
