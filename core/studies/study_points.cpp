// From the axes of a study to its settings.
#include <algorithm>
#include <bit>

#include "core/build_info.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"
#include "core/params/problem.hpp"
#include "core/scene/scene_io.hpp"
#include "core/studies/study.hpp"

namespace pf {

namespace {

/// How often i can be halved: the coarser of two levels has the larger number; 0 belongs to all of them.
int level(std::size_t i) {
  return i == 0 ? 64 : std::countr_zero(i);
}

std::string described(const std::vector<Edit>& edits) {
  std::string text;
  for (const Edit& edit : edits) text += edit.pointer + '=' + edit.value.dump() + '\n';
  return text;
}

}  // namespace

std::size_t study_size(const Study& study) {
  std::size_t count = 1;
  for (const StudyAxis& axis : study.axes) count *= axis.values.size();
  return count;
}

StudyPoint study_point(const Study& study, std::size_t k) {
  StudyPoint point{std::vector<std::size_t>(study.axes.size()), study.set};
  for (std::size_t a = study.axes.size(); a-- > 0;) {
    point.at[a] = k % study.axes[a].values.size();
    k /= study.axes[a].values.size();
  }
  for (std::size_t a = 0; a < study.axes.size(); ++a) {
    const auto& edits = study.axes[a].values[point.at[a]].edits;
    point.edits.insert(point.edits.end(), edits.begin(), edits.end());
  }
  return point;
}

std::size_t study_index(const Study& study, std::span<const std::size_t> at) {
  std::size_t k = 0;
  for (std::size_t a = 0; a < study.axes.size(); ++a) k = k * study.axes[a].values.size() + at[a];
  return k;
}

Scene study_scene(const Study& study, const StudyPoint& point) {
  return parse_scene(study.scene_text, study.scene_source, point.edits);
}

Scene reference_scene(const Study& study) {
  std::vector<Edit> edits = study.set;
  edits.insert(edits.end(), study.reference_edits.begin(), study.reference_edits.end());
  return parse_scene(study.scene_text, study.scene_source, edits);
}

std::vector<std::size_t> study_order(const Study& study) {
  std::vector<std::size_t> order(study_size(study));
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  if (study.kind != StudyKind::stability_map) return order;
  const auto coarseness = [&study](std::size_t k) {
    int least = 64;
    const StudyPoint point = study_point(study, k);
    for (std::size_t a = 0; a < study.axes.size(); ++a)
      if (study.axes[a].is_pointer()) least = std::min(least, level(point.at[a]));
    return least;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return coarseness(a) > coarseness(b); });
  return order;
}

std::vector<std::string> varied_columns(const Study& study) {
  std::vector<std::string> columns;
  const auto add = [&columns](const std::string& name) {
    if (std::find(columns.begin(), columns.end(), name) == columns.end()) columns.push_back(name);
  };
  for (const StudyAxis& axis : study.axes) {
    const bool labelled =
        std::any_of(axis.values.begin(), axis.values.end(), [](const auto& v) { return !v.label.empty(); });
    if (labelled) add(axis.key.empty() ? "label" : axis.key);
    for (const StudyValue& value : axis.values)
      for (const Edit& edit : value.edits) add(edit.pointer);
  }
  return columns;
}

std::vector<nlohmann::json> varied_values(const Study& study, const StudyPoint& point) {
  const std::vector<std::string> columns = varied_columns(study);
  std::vector<nlohmann::json> values(columns.size());
  const auto put = [&](const std::string& name, const nlohmann::json& value) {
    const auto found = std::find(columns.begin(), columns.end(), name);
    if (found != columns.end()) values[static_cast<std::size_t>(found - columns.begin())] = value;
  };
  for (std::size_t a = 0; a < study.axes.size(); ++a) {
    const StudyAxis& axis = study.axes[a];
    const StudyValue& value = axis.values[point.at[a]];
    for (const Edit& edit : value.edits) put(edit.pointer, edit.value);
    if (!value.label.empty()) put(axis.key.empty() ? "label" : axis.key, value.label);
  }
  return values;
}

namespace {

std::string identity_now() {
  const BuildInfo build = build_info();
  std::string text = std::string(build.version) + ' ' + std::string(build.commit) + ' ' + std::string(build.compiler) +
                     ' ' + std::string(build.flags);
  try {
    text += content_hash(read_file("/proc/self/exe"));  // a build with uncommitted changes is another program
  } catch (const FileError&) {
    // Not this system's way of telling; version and commit must do.
  }
  return content_hash(text);
}

}  // namespace

std::string program_identity() {
  static const std::string identity = identity_now();  // asked for at every row; the executable is large
  return identity;
}

std::string study_identity(const Study& study) {
  std::string text = content_hash(study.scene_text) + '\n' + described(study.set);
  for (std::size_t k = 0; k < study_size(study); ++k) text += "point\n" + described(study_point(study, k).edits);
  text += std::to_string(static_cast<int>(study.reference)) + described(study.reference_edits) + study.cost;
  for (const int number : {study.repeat, study.threads, study.samples}) text += ' ' + std::to_string(number);
  for (const double number : {study.timeout_s, study.thresholds.growing, study.thresholds.blown_up,
                              study.thresholds.noisy, study.thresholds.damped}) {
    text += ' ';
    append_number(text, number);
  }
  return content_hash(text);
}

}  // namespace pf
