#include "core/studies/adaptive_front.hpp"

#include <algorithm>
#include <cmath>

#include "core/files.hpp"
#include "core/output/csv_table.hpp"
#include "core/params/problem.hpp"
#include "core/studies/results.hpp"

namespace pf {

namespace {

struct Place {
  double error, cost;
};

bool is_adaptive(const Study& study, const StudyRow& row) {
  try {
    return study_scene(study, study_point(study, row.point)).time.control != "fixed";
  } catch (const InputError&) {
    return false;
  }
}

/// By rising cost and falling error.
std::vector<Place> front_of(std::vector<Place> places) {
  std::sort(places.begin(), places.end(),
            [](const Place& a, const Place& b) { return std::pair(a.cost, a.error) < std::pair(b.cost, b.error); });
  std::vector<Place> front;
  for (const Place& place : places)
    if (front.empty() || place.error < front.back().error) front.push_back(place);
  return front;
}

double cost_at(const std::vector<Place>& front, double error) {
  if (error >= front.front().error) return front.front().cost;
  for (std::size_t k = 1; k < front.size(); ++k) {
    const Place &a = front[k - 1], &b = front[k];
    if (error < b.error) continue;
    const double part = std::log(a.error / error) / std::log(a.error / b.error);
    return a.cost * std::pow(b.cost / a.cost, part);
  }
  return not_measured;
}

}  // namespace

std::vector<AgainstFront> adaptive_against_fixed(const Study& study, std::span<const StudyRow> rows) {
  std::vector<Place> fixed;
  std::vector<AgainstFront> adaptive;
  for (const StudyRow& row : rows) {
    const double cost = cost_of(study, row).value;
    const bool ended = row.behaviour != RunClass::failed && row.behaviour != RunClass::blown_up;
    if (!ended || !(row.error_l2 > 0) || !(cost > 0)) continue;
    if (is_adaptive(study, row))
      adaptive.push_back({.point = row.point, .error = row.error_l2, .cost = cost});
    else
      fixed.push_back({row.error_l2, cost});
  }
  if (fixed.empty()) return {};
  const std::vector<Place> front = front_of(std::move(fixed));
  for (AgainstFront& run : adaptive) {
    run.front_cost = cost_at(front, run.error);
    run.ratio = run.cost / run.front_cost;
  }
  return adaptive;
}

std::string adaptive_csv(const Study& study, std::span<const StudyRow> rows) {
  const std::vector<AgainstFront> runs = adaptive_against_fixed(study, rows);
  if (runs.empty()) return "";
  std::string csv;
  for (const std::string& name : varied_columns(study)) csv += csv_cell(name) + ',';
  csv += "error_l2,cost,front_cost,ratio\n";
  const auto texts = varied_texts(study);
  for (const AgainstFront& run : runs) {
    for (const std::string& text : texts[run.point]) csv += csv_cell(text) + ',';
    append_number(csv, run.error);
    for (const double value : {run.cost, run.front_cost, run.ratio}) {
      csv += ',';
      if (!std::isnan(value)) append_number(csv, value);
    }
    csv += '\n';
  }
  return csv;
}

}  // namespace pf
