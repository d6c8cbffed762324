#include "core/studies/cheapest.hpp"

#include <algorithm>

namespace pf {

namespace {

std::vector<const StudyRow*> that_count(const Study& study, std::span<const StudyRow> rows, double StudyRow::*error) {
  std::vector<const StudyRow*> good;
  for (const StudyRow& row : rows)
    if (row.status == RowStatus::ok && row.*error > 0 && cost_of(study, row).value > 0) good.push_back(&row);
  return good;
}

}  // namespace

std::optional<Cheapest> cheapest(const Study& study, std::span<const StudyRow> rows, double tolerance,
                                 std::string_view column) {
  const RowColumn* known = find_row_column(column);
  if (known == nullptr) return std::nullopt;
  std::vector<const StudyRow*> good = that_count(study, rows, known->member);
  std::erase_if(good, [&](const StudyRow* row) { return !(row->*known->member <= tolerance); });
  if (good.empty()) return std::nullopt;
  Cheapest found;
  found.best = *std::min_element(good.begin(), good.end(), [&](const StudyRow* a, const StudyRow* b) {
    return cost_of(study, *a).value < cost_of(study, *b).value;
  });
  for (const StudyRow* row : good)
    if (row != found.best && cost_of(study, *row).low <= cost_of(study, *found.best).high) found.ties.push_back(row);
  return found;
}

std::optional<std::pair<double, double>> error_range(const Study& study, std::span<const StudyRow> rows,
                                                     std::string_view column) {
  const RowColumn* known = find_row_column(column);
  if (known == nullptr) return std::nullopt;
  const std::vector<const StudyRow*> good = that_count(study, rows, known->member);
  if (good.empty()) return std::nullopt;
  const auto [least, most] = std::minmax_element(
      good.begin(), good.end(),
      [known](const StudyRow* a, const StudyRow* b) { return a->*known->member < b->*known->member; });
  return std::pair((*least)->*known->member, (*most)->*known->member);
}

}  // namespace pf
