#include "core/studies/study_io.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/assets.hpp"
#include "core/files.hpp"
#include "core/math/expression.hpp"
#include "core/params/json_text.hpp"
#include "core/params/nearest.hpp"
#include "core/params/pointer.hpp"
#include "core/scene/scene_io.hpp"
#include "core/studies/checks.hpp"
#include "core/studies/row.hpp"
#include "core/studies/study_tables.hpp"

namespace pf {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_axes = 8, most_values = 10'000, most_points = 100'000;

fs::path find_scene_of(const std::string& name, const fs::path& folder) {
  const std::string file = fs::path(name).extension().empty() ? name + ".json" : name;
  std::vector<fs::path> places{folder / name, folder / file, folder / ".." / "scenes" / file};
  for (const fs::path& root : asset_roots()) places.push_back(root / "scenes" / file);
  std::error_code ignored;
  for (const fs::path& place : places)
    if (fs::is_regular_file(place, ignored)) return place.lexically_normal();
  return {};
}

void take_scene(Reader& reader, const Json& scene, const fs::path& folder, Study& study) {
  const Reader::Step step(reader, "scene");
  if (scene.is_object()) {
    study.scene_text = scene.dump();
    study.scene_source = study.source;
  } else if (scene.is_string()) {
    const fs::path file = find_scene_of(scene.get<std::string>(), folder);
    if (file.empty()) return reader.refuse(describe(scene), "a scene file beside the study, or a shipped scene's name");
    study.scene_text = read_file(file);
    study.scene_source = file.string();
  } else if (!scene.is_null()) {
    reader.refuse(describe(scene), "a scene file's name, or a scene: an object { ... }");
  }
}

/// { "label": ..., "/pointer": value, ... }
void take_overrides(Reader& reader, const Json& json, StudyValue& value) {
  if (!json.is_object() || json.empty())
    return reader.refuse(describe(json), "an object { \"/pointer\": value, ... }, \"label\" beside them");
  for (const auto& [key, entry] : json.items()) {
    const Reader::Step step(reader, key);
    if (key == "label" && entry.is_string())
      value.label = entry.get<std::string>();
    else if (key == "label")
      reader.refuse(describe(entry), "a text");
    else if (!key.starts_with('/'))
      reader.refuse("the key " + quoted_excerpt(key), "\"label\", or a pointer such as /time/step");
    else
      value.edits.push_back({key, nlohmann::json(entry)});
  }
}

void take_axis(Reader& reader, const std::string& key, const Json& json, StudyAxis& axis) {
  axis.key = key;
  if (!json.is_array() || json.empty() || json.size() > most_values)
    return reader.refuse(describe(json), "an array of 1 to " + std::to_string(most_values) + " values");
  for (std::size_t k = 0; k < json.size(); ++k) {
    const Reader::Step step(reader, k);
    StudyValue value;
    if (axis.is_pointer())
      value.edits.push_back({key, nlohmann::json(json[k])});
    else
      take_overrides(reader, json[k], value);
    for (const StudyValue& earlier : axis.values)
      if (earlier.edits == value.edits) {
        reader.refuse(describe(json[k]) + " a second time", "each value once");
        break;
      }
    axis.values.push_back(std::move(value));
  }
}

void take_vary(Reader& reader, const Json& vary, Study& study) {
  const Reader::Step step(reader, "vary");
  if (vary.is_array()) {
    study.axes.emplace_back();
    take_axis(reader, "", vary, study.axes.back());
  } else if (vary.is_object() && !vary.empty() && vary.size() <= most_axes) {
    for (const auto& [key, values] : vary.items()) {
      const Reader::Step below(reader, key);
      study.axes.emplace_back();
      take_axis(reader, key, values, study.axes.back());
    }
  } else if (!vary.is_null()) {
    reader.refuse(describe(vary), "an object { \"/pointer\": [values], ... } of 1 to " + std::to_string(most_axes) +
                                      " axes, or an array of override objects");
  }
  double points = 1;
  for (const StudyAxis& axis : study.axes) points *= static_cast<double>(axis.values.size());
  if (points > static_cast<double>(most_points))
    reader.refuse(number_text(points) + " runs", "at most " + std::to_string(most_points));
}

void take_reference(Reader& reader, const Json& reference, Study& study) {
  const Reader::Step step(reader, "reference");
  if (reference.is_null()) return;
  if (reference == "exact") {
    study.reference = ReferenceKind::exact;
    return;
  }
  if (!reference.is_object())
    return reader.refuse(describe(reference), "\"exact\", or an object of overrides: a fine run of the same scene");
  study.reference = ReferenceKind::run;
  StudyValue value;
  if (!reference.empty()) take_overrides(reader, reference, value);
  study.reference_edits = std::move(value.edits);
}

/// A map has two axes of numbers first; charts and lines name columns that exist.
/// Columns of numbers exist, rows can match, and something is bounded.
void check_checks(Reader& reader, const Study& study) {
  const std::vector<std::string> numbers = row_column_names(), varied = varied_columns(study);
  for (std::size_t k = 0; k < study.checks.size(); ++k) {
    const StudyCheck& check = study.checks[k];
    const std::string pointer = "/checks/" + std::to_string(k);
    if (find_row_column(check.of) == nullptr)
      reader.refuse(pointer + "/of", quoted_excerpt(check.of), suggest(check.of, numbers));
    if (!check.order_in.empty() && find_row_column(check.order_in) == nullptr)
      reader.refuse(pointer + "/order_in", quoted_excerpt(check.order_in), suggest(check.order_in, numbers));
    if (!check.above && !check.below) reader.refuse(pointer, "a check without bounds", "above, below, or both");
    if (check.above && check.below && !(*check.above < *check.below))
      reader.refuse(pointer + "/above", "a bound that is not less than below", "above < below");
    for (const auto& [column, value] : check.where.items()) {
      if (std::find(varied.begin(), varied.end(), column) == varied.end())
        reader.refuse(pointer + "/where" + pointer_step(column), quoted_excerpt(column), suggest(column, varied));
    }
    if (reader.refused() == 0 && matching_points(study, check).empty())
      reader.refuse(pointer + "/where", check.where.dump(), "values that are varied");
  }
}

void check_charts(Reader& reader, const Study& study) {
  std::vector<std::string> names = row_column_names();
  const std::vector<std::string> varied = varied_columns(study);
  names.insert(names.end(), varied.begin(), varied.end());
  names.emplace_back("cost");
  const auto check = [&](const std::string& pointer, const std::string& name, bool may_be_empty) {
    if ((may_be_empty && name.empty()) || std::find(names.begin(), names.end(), name) != names.end()) return;
    reader.refuse(pointer, quoted_excerpt(name), suggest(name, names));
  };
  for (std::size_t k = 0; k < study.charts.size(); ++k) {
    const std::string pointer = "/charts/" + std::to_string(k);
    check(pointer + "/x", study.charts[k].x, false);
    check(pointer + "/y", study.charts[k].y, false);
    check(pointer + "/lines", study.charts[k].lines, true);
    if (study.charts[k].name.find('/') != std::string::npos)
      reader.refuse(pointer + "/name", quoted_excerpt(study.charts[k].name), "a file name without folders");
  }
  check("/along", study.along, true);
  for (const auto& [column, title] : study.titles) check("/titles" + pointer_step(column), column, false);
  if (study.kind != StudyKind::stability_map) return;
  const auto numbers = [](const StudyAxis& axis) {
    return axis.is_pointer() && axis.values.size() > 1 &&
           std::all_of(axis.values.begin(), axis.values.end(),
                       [](const StudyValue& v) { return v.edits[0].value.is_number(); });
  };
  if (std::count_if(study.axes.begin(), study.axes.end(), numbers) < 2)
    reader.refuse("/vary", "fewer than two pointers with several numbers each",
                  "for a stability map, two of them: the first is drawn across, the second up");
  for (std::size_t k = 0; k < study.limits.size(); ++k) {
    const StudyLimit& limit = study.limits[k];
    const std::string pointer = "/limits/" + std::to_string(k);
    if (limit.x.empty() == limit.y.empty()) {
      reader.refuse(pointer, "x and y both or neither", "one of them: an expression in the other");
      continue;
    }
    const std::string end = limit.y.empty() ? "/x" : "/y";
    try {
      Expression::compile(limit.y.empty() ? limit.x : limit.y, {}, 1u << (limit.y.empty() ? var_y : var_x));
    } catch (const ExpressionError& error) {
      reader.refuse(pointer + end, error.what(), std::string("an expression in ") + (limit.y.empty() ? "y" : "x"));
    }
  }
}

/// Every run's scene is made once. A value that none of its runs can use is a problem of the study.
void check_runs(Reader& reader, const Study& study) {
  const std::size_t count = study_size(study);
  std::vector<std::vector<bool>> usable(study.axes.size());
  std::map<std::pair<std::size_t, std::size_t>, Problem> why;
  for (std::size_t a = 0; a < study.axes.size(); ++a) usable[a].resize(study.axes[a].values.size());
  for (std::size_t k = 0; k < count; ++k) {
    const StudyPoint point = study_point(study, k);
    try {
      study_scene(study, point);
      for (std::size_t a = 0; a < point.at.size(); ++a) usable[a][point.at[a]] = true;
    } catch (const InputError& error) {
      for (std::size_t a = 0; a < point.at.size(); ++a)
        for (const Problem& problem : error.problems())
          for (const Edit& edit : study.axes[a].values[point.at[a]].edits)
            if (is_at_or_below(problem.pointer, edit.pointer) || is_at_or_below(edit.pointer, problem.pointer))
              why.emplace(std::pair(a, point.at[a]), problem);
      if (k == 0 && why.empty()) why.emplace(std::pair<std::size_t, std::size_t>(0, 0), error.problems().front());
    }
  }
  for (std::size_t a = 0; a < study.axes.size(); ++a)
    for (std::size_t v = 0; v < usable[a].size(); ++v) {
      const auto problem = why.find({a, v});
      if (usable[a][v] || problem == why.end()) continue;
      const std::string key = study.axes[a].key.empty() ? "" : pointer_step(study.axes[a].key);
      reader.refuse("/vary" + key + "/" + std::to_string(v),
                    problem->second.found + " at " + problem->second.pointer + " of the scene",
                    problem->second.allowed);
    }
}

/// Times of comparison with a run must be ends of steps in every run.
void check_samples(Reader& reader, const Study& study) {
  if (study.reference != ReferenceKind::run || study.samples == 1) return;
  const auto divides = [&study](const Scene& scene) {
    if (scene.time.control != "fixed") return true;  // lands on them
    const double steps = scene.time.end / study.samples / scene.time.step;
    return std::abs(steps - std::round(steps)) < 1e-6 * std::max(1.0, steps);
  };
  bool good = divides(reference_scene(study));
  for (std::size_t k = 0; k < study_size(study) && good; ++k) {
    try {
      good = divides(study_scene(study, study_point(study, k)));
    } catch (const InputError&) {
      continue;  // becomes a row that says why
    }
  }
  if (!good)
    reader.refuse("/samples", std::to_string(study.samples),
                  "with a run as reference, a number whose times every run's steps meet; 1: the end alone");
}

/// Without a word on it a study is measured against the exact motion, where the scene has one.
void check_scene_of(Reader& reader, Study& study, bool said, bool inline_scene) {
  try {
    const Scene base = parse_scene(study.scene_text, study.scene_source, study.set);
    if (!said && !base.exact_position.empty()) study.reference = ReferenceKind::exact;
    if (study.reference == ReferenceKind::exact && base.exact_position.empty()) {
      reader.refuse("/reference", "\"exact\" for a scene whose motion is not known",
                    "an object of overrides: a fine run of the same scene");
      return;
    }
    if (study.reference == ReferenceKind::run) reference_scene(study);
  } catch (const InputError& error) {
    for (const Problem& problem : error.problems()) {
      const auto is_edit = [&problem](const Edit& e) { return is_at_or_below(problem.pointer, e.pointer); };
      const bool by_set = std::any_of(study.set.begin(), study.set.end(), is_edit);
      const bool by_reference = std::any_of(study.reference_edits.begin(), study.reference_edits.end(), is_edit);
      if (by_set || by_reference)
        reader.refuse((by_reference ? "/reference" : "/set") + pointer_step(problem.pointer), problem.found,
                      problem.allowed);
      else if (inline_scene)
        reader.refuse("/scene" + problem.pointer, problem.found, problem.allowed);
      else
        throw;
    }
  }
}

}  // namespace

Study parse_study(std::string_view text, const std::string& source, const fs::path& folder) {
  std::vector<Problem> problems;
  const Json document = read_json(text, source, problems);
  Reader reader(2, {});
  StudyDocument read;
  read.study.source = source;
  read_table(reader, study_table(), document, &read);
  Study& study = read.study;
  take_scene(reader, read.scene, folder, study);
  take_vary(reader, read.vary, study);
  take_reference(reader, read.reference, study);
  if (reader.refused() == 0) check_scene_of(reader, study, !read.reference.is_null(), read.scene.is_object());
  if (reader.refused() == 0) check_charts(reader, study);
  if (reader.refused() == 0) check_checks(reader, study);
  if (reader.refused() == 0) check_runs(reader, study);
  if (reader.refused() == 0) check_samples(reader, study);
  for (Problem& problem : reader.take_problems()) problems.push_back(std::move(problem));
  if (!problems.empty()) {
    std::vector<std::string> pointers;
    pointers.reserve(problems.size());
    for (const Problem& problem : problems) pointers.push_back(problem.pointer);
    const std::vector<int> lines = json_lines(text, pointers);
    for (std::size_t k = 0; k < problems.size(); ++k)
      if (problems[k].line == 0) problems[k].line = lines[k];
    throw InputError(source, std::move(problems));
  }
  if (study.cost != "wall") study.repeat = 1;
  if (study.measure.empty()) study.measure = "energy_gained";
  return std::move(read.study);
}

Study load_study(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) throw FileError(file.string() + ": is a folder, not a study file");
  return parse_study(read_file(file), file.string(), file.parent_path());
}

std::string self_contained(std::string_view text, const Study& study) {
  using nlohmann::ordered_json;
  constexpr bool comments = true;
  ordered_json document = ordered_json::parse(text, nullptr, true, comments);
  document["scene"] = ordered_json::parse(study.scene_text, nullptr, true, comments);
  return document.dump(2) + '\n';
}

}  // namespace pf
