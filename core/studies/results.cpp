#include "core/studies/results.hpp"

#include <algorithm>
#include <cmath>
#include <thread>

#include "core/build_info.hpp"
#include "core/output/summary.hpp"
#include "core/scene/scene_io.hpp"
#include "core/studies/cheapest.hpp"
#include "core/work_weights.hpp"

namespace pf {

namespace {

using nlohmann::ordered_json;

std::string text_of(const nlohmann::json& value) {
  return value.is_null() ? "" : value.is_string() ? value.get<std::string>() : value.dump();
}

ordered_json edits_of(const std::vector<Edit>& edits) {
  ordered_json object = ordered_json::object();
  for (const Edit& edit : edits) object[edit.pointer] = edit.value;
  return object;
}

ordered_json reference_of(const Study& study) {
  if (study.reference == ReferenceKind::none) return nullptr;
  if (study.reference == ReferenceKind::exact) return "exact";
  return edits_of(study.reference_edits);
}

}  // namespace

std::vector<std::vector<std::string>> varied_texts(const Study& study) {
  std::vector<std::vector<std::string>> texts;
  for (std::size_t k = 0; k < study_size(study); ++k) {
    std::vector<std::string>& row = texts.emplace_back();
    for (const nlohmann::json& value : varied_values(study, study_point(study, k))) row.push_back(text_of(value));
  }
  return texts;
}

std::string results_csv(const Study& study, std::span<const StudyRow> rows) {
  const auto texts = varied_texts(study);
  std::string csv = results_header(varied_columns(study)) + '\n';
  for (const StudyRow& row : rows) csv += results_row(row, texts[row.point]) + '\n';
  return csv;
}

ordered_json study_document(const Study& study, std::size_t finished) {
  const BuildInfo build = build_info();
  ordered_json text{{"format", "pushforward/study-results"},
                    {"identity", study_identity(study)},
                    {"program", program_identity()},
                    {"name", study.name},
                    {"about", study.about},
                    {"study", study.source},
                    {"scene", study.scene_source},
                    {"kind", study.kind == StudyKind::work_precision ? "work_precision" : "stability_map"},
                    {"runs", study_size(study)},
                    {"finished", finished},
                    {"set", edits_of(study.set)},
                    {"reference", reference_of(study)},
                    {"cost", study.cost},
                    {"repeat", study.repeat},
                    {"timeout_s", study.timeout_s},
                    {"threads", study.threads},
                    {"samples", study.samples}};
  const StudyThresholds& t = study.thresholds;
  text["thresholds"] = {{"growing", t.growing}, {"blown_up", t.blown_up}, {"noisy", t.noisy}, {"damped", t.damped}};
  text["work_weights"] = {{"note", kernel_weights_note()}};
  for (const KernelWeight& weight : kernel_weights())
    text["work_weights"][std::string(weight.kernel)] = {{"2D", weight.two}, {"3D", weight.three}};
  text["version"] = build.version;
  text["commit"] = build.commit;
  text["compiler"] = build.compiler;
  text["flags"] = build.flags;
  text["cpu"] = processor_name();
  text["hardware_threads"] = std::thread::hardware_concurrency();
  return text;
}

Cost cost_of(const Study& study, const StudyRow& row) {
  if (study.cost == "work") return {row.work, row.work, row.work};
  return {row.wall, row.wall_min, row.wall_max};
}

ordered_json best_document(const Study& study, std::span<const StudyRow> rows) {
  ordered_json text{{"format", "pushforward/study-best"}, {"cost", study.cost}, {"best", ordered_json::array()}};
  const auto range = error_range(study, rows);
  if (!range) return text;
  const auto [least, most] = *range;
  const std::vector<std::string> columns = varied_columns(study);
  const auto setting = [&](const StudyRow& row) {
    ordered_json object = ordered_json::object();
    const auto values = varied_values(study, study_point(study, row.point));
    for (std::size_t k = 0; k < columns.size(); ++k)
      if (!values[k].is_null()) object[columns[k]] = values[k];
    return object;
  };
  for (int decade = static_cast<int>(std::ceil(std::log10(most))); std::pow(10, decade) >= least; --decade) {
    const double tolerance = std::pow(10, decade);
    const std::optional<Cheapest> found = cheapest(study, rows, tolerance);
    if (!found) break;
    ordered_json entry{{"tolerance", tolerance},
                       {"setting", setting(*found->best)},
                       {"error_l2", found->best->error_l2},
                       {"cost", cost_of(study, *found->best).value},
                       {"ties", ordered_json::array()}};
    for (const StudyRow* row : found->ties) entry["ties"].push_back(setting(*row));
    text["best"].push_back(entry);
  }
  return text;
}

}  // namespace pf
