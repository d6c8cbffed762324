// Properties that every setting of the table must have: a new row is tested by being listed.
#include "core/params/setting.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "core/params/pointer.hpp"
#include "scene_text.hpp"

using namespace pf;
using Json = nlohmann::ordered_json;

namespace {

/// A scene that holds a setting, and where.
struct Holder {
  Json scene;
  std::string pointer;
  Json& value() { return scene[Json::json_pointer(pointer)]; }
  Json& parent() { return scene[Json::json_pointer(pointer).parent_pointer()]; }
};

Json full_scene_3d() {
  Json scene = small_scene(3);
  const Json box = scene["bodies"][0]["shape"];
  scene["bodies"][0]["name"] = "block";
  scene["boundaries"] = Json::array({{{"shape", box}}});
  scene["constraints"] = Json::array({{{"region", box}, {"fix", {true, true, true}}}});
  scene["events"] = Json::array({{{"time", 1}, {"strokes", {{{"kind", "cut"}, {"shape", box}}}}}});
  scene["loads"] = Json::array({{{"body", "block"}, {"region", box}, {"traction", {0, 0, 0}}}});
  return scene;
}

/// A shape that has this key.
Json shape_with(const std::string& key) {
  if (key == "center" || key == "radius") return {{"type", "ball"}, {"center", {0, 0}}, {"radius", 1}};
  if (key == "from" || key == "to")
    return {{"type", "cylinder"}, {"from", {0, 0, 0}}, {"to", {0, 0, 1}}, {"radius", 1}};
  if (key == "points") return {{"type", "polygon"}, {"points", {{0, 0}, {1, 0}, {0, 1}}}};
  if (key == "point" || key == "normal") return {{"type", "half_space"}, {"point", {0, 0}}, {"normal", {0, 1}}};
  if (key == "expression") return {{"type", "where"}, {"expression", "1 - X^2"}, {"min", {0, 0}}, {"max", {1, 1}}};
  return {{"type", "box"}, {"min", {0, 0}}, {"max", {1, 1}}, {"scale", 1}, {"rotate", 0}, {"translate", {0, 0}}};
}

Holder holder_of(const Setting& setting) {
  std::vector<std::string> steps = *split_pointer(setting.pointer);
  const std::size_t below = steps.size() > 2 && steps[2] == "strokes" ? 5 : 3;  // of the shape, its keys
  const bool shape = steps.size() > below && (steps[below - 1] == "shape" || steps[below - 1] == "region");
  const std::string key = steps.back();
  const bool solid = shape && (key == "from" || key == "to");
  Holder holder{solid ? full_scene_3d() : full_scene(), ""};
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (steps[k] == "*") steps[k] = steps[0] == "materials" ? "rubber" : steps[0] == "constants" ? "A" : "0";
    if (shape && k == below) {
      Json made = shape_with(key);
      Json& place = holder.scene[Json::json_pointer(holder.pointer)];
      if (steps[0] == "bodies" && made["type"] == "half_space") {  // a body must be bounded
        place = {{"type", "intersection"}, {"of", {shape_with("min"), made}}};
        holder.pointer += "/of/1";
      } else {
        place = made;
      }
    }
    holder.pointer += pointer_step(steps[k]);
  }
  if (steps[0] == "exact") {
    holder.scene["exact"] = {{"position", {"X", "Y"}}};
    holder.scene["bodies"][0].erase("velocity");
    holder.scene["events"][0].erase("strokes");
  }
  if (steps[0] == "manufactured") holder.scene["manufactured"] = false;
  return holder;
}

/// Is it refused, at the pointer or below it?
void check_refused(const Holder& holder, const std::string& text, const char* why) {
  const std::vector<Problem> problems = problems_of(text);
  bool found = false;
  for (const Problem& problem : problems) {
    found = found || (is_at_or_below(problem.pointer, holder.pointer) && !problem.found.empty() &&
                      !problem.allowed.empty() && problem.line == 1);
  }
  CHECK_MESSAGE(found, why << ": " << holder.pointer << " in " << text << "\n" << list(problems));
}

/// Values of a wrong type for a setting.
std::vector<Json> mistyped(const Setting& setting) {
  std::vector<Json> wrong = {nullptr, Json::object()};
  const bool text = setting.kind == SettingKind::text || setting.kind == SettingKind::choice;
  const bool list_of = setting.kind == SettingKind::vector || setting.kind == SettingKind::formula_vector ||
                       setting.kind == SettingKind::flag_vector;
  if (text) wrong.push_back(5);
  if (!text) wrong.push_back("no such thing");
  if (setting.kind != SettingKind::flag) wrong.push_back(true);
  if (!list_of) wrong.push_back(Json::array({1, 2}));
  if (list_of)
    wrong.insert(wrong.end(),
                 {Json::array(), Json::array({1}), Json::array({1, 2, 3, 4}), Json::array({nullptr, nullptr})});
  if (setting.kind == SettingKind::integer) wrong.push_back(1.5);
  return wrong;
}

/// Numbers that the range leaves out.
std::vector<double> beyond(const Setting& setting) {
  std::vector<double> out;
  const auto step = [](double end) { return std::max(1.0, std::abs(end)); };
  if (std::isfinite(setting.min)) out.push_back(setting.open_min ? setting.min : setting.min - step(setting.min));
  if (std::isfinite(setting.max)) out.push_back(setting.open_max ? setting.max : setting.max + step(setting.max));
  return out;
}

}  // namespace

TEST_CASE("every setting is accepted where it belongs") {
  for (const Setting& setting : settings()) {
    Holder holder = holder_of(setting);
    CAPTURE(holder.pointer);
    CHECK_MESSAGE(problems_in(holder.scene).empty(), list(problems_in(holder.scene)));
    CHECK(find_setting(holder.pointer) == &setting);
  }
}

TEST_CASE("every key is refused when it is unknown, and the right one is suggested") {
  for (const Setting& setting : settings()) {
    if (setting.pointer == "/constants/*") continue;  // names are free there
    Holder holder = holder_of(setting);
    const std::string key = split_pointer(holder.pointer)->back();
    holder.parent()[key + "q"] = holder.value();
    holder.pointer += "q";
    check_refused(holder, holder.scene.dump(), "unknown key");
    const std::string message = list(problems_in(holder.scene));
    CHECK_MESSAGE(message.find(key) != std::string::npos, message);
  }
}

TEST_CASE("every key is refused when it stands twice") {
  for (const Setting& setting : settings()) {
    Holder holder = holder_of(setting);
    CAPTURE(holder.pointer);
    const std::string key = split_pointer(holder.pointer)->back();
    if (!holder.parent().contains(key)) continue;
    holder.parent()["@"] = holder.value();
    std::string text = holder.scene.dump();
    text.replace(text.find("\"@\""), 3, "\"" + key + "\"");
    check_refused(holder, text, "duplicate key");
  }
}

TEST_CASE("every setting is refused when it has the wrong type") {
  for (const Setting& setting : settings()) {
    for (const Json& wrong : mistyped(setting)) {
      Holder holder = holder_of(setting);
      holder.value() = wrong;
      check_refused(holder, holder.scene.dump(), "mistyped");
    }
  }
}

TEST_CASE("every number is refused beyond its range, and overflowing ones everywhere") {
  for (const Setting& setting : settings()) {
    if (setting.kind == SettingKind::text || setting.kind == SettingKind::choice || setting.kind == SettingKind::flag ||
        setting.kind == SettingKind::flag_vector)
      continue;
    std::vector<std::string> numbers = {"1e999", "-1e999"};
    for (const double value : beyond(setting)) numbers.push_back(Json(value).dump());
    for (const std::string& number : numbers) {
      Holder holder = holder_of(setting);
      const bool list_of = setting.kind == SettingKind::vector || setting.kind == SettingKind::formula_vector;
      const bool points = setting.pointer.ends_with("/points");
      if (list_of) holder.pointer += points ? "/1/0" : "/0";
      holder.value() = "@";
      std::string text = holder.scene.dump();
      text.replace(text.find("\"@\""), 3, number);
      check_refused(holder, text, "out of range");
    }
  }
}

TEST_CASE("every choice is accepted, and any other name refused with the choices") {
  for (const Setting& setting : settings()) {
    if (setting.kind != SettingKind::choice) continue;
    CHECK(!setting.choices.empty());
    for (const std::string& choice : setting.choices) {
      if (setting.pointer.find("/shape/") != std::string::npos || setting.pointer.find("/region/") != std::string::npos)
        break;
      Holder holder = holder_of(setting);
      holder.value() = choice;
      if (choice == "cut") holder.parent().erase("material");
      CHECK_MESSAGE(problems_in(holder.scene).empty(), list(problems_in(holder.scene)));
    }
    Holder holder = holder_of(setting);
    holder.value() = setting.choices[0] + "z";
    check_refused(holder, holder.scene.dump(), "choice");
    CHECK(list(problems_in(holder.scene)).find(setting.choices.back()) != std::string::npos);
  }
}

TEST_CASE("what is not built yet is refused like an unknown value") {
  const std::pair<const char*, Json> absent[] = {{"/bodies/0/shape/type", "image"}, {"/bodies/0/shape/type", "mesh"}};
  for (const auto& [pointer, value] : absent) {
    Json scene = full_scene();
    scene[Json::json_pointer(pointer)] = value;
    CHECK_MESSAGE(has_problem(problems_in(scene), pointer), pointer);
  }
}

TEST_CASE("every setting says what a widget needs") {
  std::set<std::string> pointers;
  for (const Setting& setting : settings()) {
    CAPTURE(setting.pointer);
    CHECK(pointers.insert(setting.pointer).second);
    CHECK(!setting.label.empty());
    CHECK(setting.help.size() > 5);
    CHECK(setting.help.back() == '.');
    const bool number = setting.kind == SettingKind::number || setting.kind == SettingKind::vector ||
                        setting.kind == SettingKind::integer || setting.kind == SettingKind::formula_vector;
    if (!number) continue;
    CHECK(setting.slider_min < setting.slider_max);
    CHECK((!setting.logarithmic || setting.slider_min > 0));
    if (setting.pointer == "/dimension" || setting.pointer == "/version") continue;
    CHECK(setting.slider_min >= setting.min);
    CHECK(setting.slider_max <= setting.max);
  }
}

TEST_CASE("settings are found from any place below them") {
  CHECK(find_setting("/gravity/1") == find_setting("/gravity"));
  CHECK(find_setting("/gravity")->unit == "m/s^2");
  CHECK(find_setting("/materials/any name/young")->unit == "Pa");
  CHECK(find_setting("/bodies/3/shape/of/1/of/0/radius") == find_setting("/bodies/0/shape/radius"));
  CHECK(find_setting("/bodies/3/shape/points/2/1") == find_setting("/bodies/0/shape/points"));
  CHECK(find_setting("/time/step")->applies == Applies::live);
  CHECK(find_setting("/grid/spacing")->applies == Applies::reset);
  CHECK(find_setting("/view/color_by")->applies == Applies::view);
  for (const char* const nothing : {"", "time", "/time", "/time/steps", "/time/step/0", "/bodies/0", "/x/y"})
    CHECK(!find_setting(nothing));
}
