// What a study leaves in its folder beside the charts: results.csv, study.json, best.json.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/studies/row.hpp"
#include "core/studies/study.hpp"

namespace pf {

/// Texts of the varied columns of every setting.
std::vector<std::vector<std::string>> varied_texts(const Study& study);
/// The whole results.csv; rows by setting.
std::string results_csv(const Study& study, std::span<const StudyRow> rows);
/// What was run, against what, on which machine, and the thresholds and weights behind the numbers.
nlohmann::ordered_json study_document(const Study& study, std::size_t finished);
/// For each decade of tolerance the cheapest setting whose error is below it, and those that cost the same within the
/// timing's noise.
nlohmann::ordered_json best_document(const Study& study, std::span<const StudyRow> rows);

/// A row's cost as the study counts it, and the interval it is known in: least and most of the timed runs.
struct Cost {
  double value = not_measured, low = not_measured, high = not_measured;
};
Cost cost_of(const Study& study, const StudyRow& row);

}  // namespace pf
