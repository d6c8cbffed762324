#include "core/studies/checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pf {

namespace {

/// How far a value is above its bounds, below 0 within them; in decades, or as it stands where a bound is not positive.
double excess(const StudyCheck& check, double value) {
  const auto over = [](double high, double low) { return high > 0 && low > 0 ? std::log10(high / low) : high - low; };
  double most = -std::numeric_limits<double>::infinity();
  if (check.below) most = std::max(most, over(value, *check.below));
  if (check.above) most = std::max(most, over(*check.above, value));
  return most;
}

const StudyRow* find_row(std::span<const StudyRow> rows, std::size_t point) {
  const auto found = std::ranges::find(rows, point, &StudyRow::point);
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace

std::vector<std::size_t> matching_points(const Study& study, const StudyCheck& check) {
  const std::vector<std::string> columns = varied_columns(study);
  std::vector<std::size_t> points;
  for (std::size_t k = 0; k < study_size(study); ++k) {
    const std::vector<nlohmann::json> values = varied_values(study, study_point(study, k));
    const bool matches = std::ranges::all_of(check.where.items(), [&](const auto& wanted) {
      const auto at = static_cast<std::size_t>(std::ranges::find(columns, wanted.key()) - columns.begin());
      return at < columns.size() && values[at] == wanted.value();
    });
    if (matches) points.push_back(k);
  }
  return points;
}

CheckResult evaluate(const Study& study, const StudyCheck& check, std::span<const StudyRow> rows) {
  CheckResult result;
  const RowColumn* const column = find_row_column(check.of);
  const RowColumn* const x = check.order_in.empty() ? nullptr : find_row_column(check.order_in);
  std::vector<double> numbers, places;
  for (const std::size_t point : matching_points(study, check)) {
    const StudyRow* const row = find_row(rows, point);
    // How far a run came is known of one that could not go on, too.
    const bool fits = row != nullptr && (row->status != RowStatus::failed || check.of == "end_time");
    if (!fits || row->status == RowStatus::timeout) {
      result.reason = row == nullptr ? "a run is missing" : row->reason;
      return result;
    }
    const double number = row->*column->member;
    numbers.push_back(check.exact ? std::abs(number - *check.exact) / check.per : number / check.per);
    places.push_back(x != nullptr ? row->*x->member : 0);
  }
  if (x != nullptr) {
    for (std::size_t k = 1; k < numbers.size(); ++k)
      result.values.push_back(std::log(numbers[k] / numbers[k - 1]) / std::log(places[k] / places[k - 1]));
  } else {
    result.values = numbers;
  }
  if (check.rows == "last" && result.values.size() > 1)
    result.values.erase(result.values.begin(), result.values.end() - 1);
  if (result.values.empty()) {
    result.reason = "an order needs two runs";
    return result;
  }
  result.passed = true;
  double most = -std::numeric_limits<double>::infinity();
  for (const double value : result.values) {
    const double out = std::isfinite(value) ? excess(check, value) : std::numeric_limits<double>::infinity();
    result.passed = result.passed && out <= 0;
    if (out >= most) result.worst = value;
    most = std::max(most, out);
  }
  if (!std::isfinite(result.worst)) result.reason = "not measured";
  return result;
}

std::string bounds_text(const StudyCheck& check) {
  char text[80];
  if (check.above && check.below)
    std::snprintf(text, sizeof text, "%.3g to %.3g", *check.above, *check.below);
  else
    std::snprintf(text, sizeof text, check.below ? "at most %.3g" : "at least %.3g",
                  check.below ? *check.below : *check.above);
  return text;
}

}  // namespace pf
