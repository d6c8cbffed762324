// What no single key can say: references, combinations that cannot work, events.
#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "core/integrators/integrator.hpp"
#include "core/math/expression_names.hpp"
#include "core/params/json_text.hpp"
#include "core/params/nearest.hpp"
#include "core/params/pointer.hpp"
#include "core/scene/live_lists.hpp"
#include "core/scene/tables.hpp"

namespace pf {
namespace {

constexpr std::size_t most_constants = 1'000;
constexpr double most_steps = 1e9;
constexpr double most_event_work = 2e7;  // values visited by all checks of events together

bool is_identifier(std::string_view name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  if (name.empty() || name.size() > 64 || !letter(name[0])) return false;
  return std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

/// Does the name mean something in expressions already: a variable, a function, pi?
bool is_reserved(std::string_view name) {
  return name == "pi" || find_expression_function(name) ||
         std::find(std::begin(all_variables), std::end(all_variables), name) != std::end(all_variables);
}

template <class Item>
std::vector<std::string> names_of(const std::vector<Item>& items) {
  std::vector<std::string> names;
  names.reserve(items.size());
  for (const Item& item : items) names.push_back(item.name);
  return names;
}

template <class Item>
void check_unique(Reader& reader, const std::vector<Item>& items, std::string_view list) {
  std::unordered_set<std::string> seen;
  for (std::size_t k = 0; k < items.size(); ++k) {
    if (seen.insert(items[k].name).second) continue;
    reader.refuse("/" + std::string(list) + "/" + std::to_string(k) + "/name",
                  quoted_excerpt(items[k].name) + " a second time", "each name once");
  }
}

/// `name` is "" where it could not be read: that is a problem already.
void check_known(Reader& reader, const std::string& pointer, const std::string& name,
                 const std::vector<std::string>& known) {
  if (name.empty() || known.empty() || std::find(known.begin(), known.end(), name) != known.end()) return;
  reader.refuse(pointer, quoted_excerpt(name), suggest(name, known));
}

void check_references(Reader& reader, const Scene& scene) {
  const std::vector<std::string> materials = names_of(scene.materials), bodies = names_of(scene.bodies);
  for (std::size_t k = 0; k < scene.bodies.size(); ++k)
    check_known(reader, "/bodies/" + std::to_string(k) + "/material", scene.bodies[k].material, materials);
  for (std::size_t k = 0; k < scene.loads.size(); ++k)
    check_known(reader, "/loads/" + std::to_string(k) + "/body", scene.loads[k].body, bodies);
  check_unique(reader, scene.bodies, "bodies");
  check_unique(reader, scene.probes, "probes");
}

void check_colors(Reader& reader, const ViewSettings& view) {
  if (view.color_min.has_value() != view.color_max.has_value())
    return reader.refuse(view.color_min ? "/view/color_max" : "/view/color_min", "nothing", "both ends or none");
  if (!view.color_min) return;
  if (!(*view.color_min < *view.color_max))
    reader.refuse("/view/color_max", describe(Json(*view.color_max)), "a number above color_min");
  if (view.color_log && !(*view.color_min > 0))
    reader.refuse("/view/color_min", describe(Json(*view.color_min)), "a number above zero with color_log");
}

std::string adaptive_integrators() {
  std::string names;
  for (const IntegratorInfo& info : integrators())
    if (info.adaptive) names += (names.empty() ? "" : ", ") + std::string(info.name);
  return names;
}

/// `exact` gives the initial velocity (fine print 5): one in the file would contradict it.
void check_exact(Reader& reader, const Scene& scene, const Json& document) {
  const bool exact = document.contains("exact");
  if (scene.manufactured && !exact)
    reader.refuse("/manufactured", "true without \"exact\"", "true only beside the motion that \"exact\" gives");
  if (scene.manufactured && document.contains("body_force"))
    reader.refuse("/body_force", "a body force beside \"manufactured\"", "none: the manufactured solution derives it");
  if (!exact || !document.contains("bodies") || !document["bodies"].is_array()) return;
  const Json& bodies = document["bodies"];
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].is_object() && bodies[k].contains("velocity"))
      reader.refuse("/bodies/" + std::to_string(k) + "/velocity", "a velocity beside \"exact\"",
                    "none: \"exact\" gives the initial velocity");
  }
}

/// What a time scheme cannot be combined with.
void check_integrator(Reader& reader, const Scene& scene) {
  const IntegratorInfo* integrator = find_integrator(scene.integrator.type);
  if (!integrator) return;
  if (scene.time.control == "adaptive" && !integrator->adaptive)
    reader.refuse("/time/control", "\"adaptive\" beside the integrator " + quoted_excerpt(scene.integrator.type),
                  "\"fixed\", or an integrator whose error adaptive steps know: " + adaptive_integrators());
  if (scene.manufactured && !integrator->inertia)
    reader.refuse(
        "/manufactured", "true beside " + quoted_excerpt(scene.integrator.type),
        "false: the forces that it derives balance the motion's inertia, which a quasi-static step leaves out");
}

std::size_t count_values(const Json& json) {
  std::size_t count = 1;
  if (json.is_structured()) {
    for (const Json& item : json) count += count_values(item);
  }
  return count;
}

/// Events edit a copy of the document without the events themselves, and without names that could be long.
Json without_events(const Json& document) {
  Json copy = document;
  copy.erase("events");
  return copy;
}

/// Adds problems of one event's edits; false when there were any.
bool apply_event(Reader& reader, const Event& event, Json& document) {
  const std::size_t before = reader.refused();
  for (const Edit& edit : event.set) {
    const Reader::Step step(reader, edit.pointer);
    const Setting* setting = find_setting(edit.pointer);
    std::vector<Problem> problems;
    std::string changed;
    if (!apply_edit(document, edit.pointer, Json(edit.value), problems, changed)) {
      for (Problem& problem : problems) reader.refuse(std::move(problem.found), std::move(problem.allowed));
    } else if (comes_or_goes_live(edit.pointer)) {
      continue;  // it enters the running simulation, or leaves it
    } else if (!setting || setting->applies == Applies::reset) {
      reader.refuse("a change of " + edit.pointer + ", which applies only at a reset", "settings that apply live");
    }
  }
  return reader.refused() == before;
}

/// What strokes refer to. The materials are those of the whole run.
void check_strokes(Reader& reader, const Scene& scene, const Event& event) {
  const std::vector<std::string> materials = names_of(scene.materials);
  const Reader::Step list(reader, "strokes");
  if (!event.strokes.empty() && !scene.exact_position.empty())
    reader.refuse("strokes beside \"exact\"", "none: the motion that \"exact\" says is that of the whole bodies");
  for (std::size_t k = 0; k < event.strokes.size(); ++k) {
    const Stroke& stroke = event.strokes[k];
    const Reader::Step at(reader, k);
    const Reader::Step step(reader, "material");
    if (stroke.kind == "cut" && !stroke.material.empty())
      reader.refuse("a material beside \"cut\"", "none, or the kind \"paint\"");
    if (stroke.kind != "paint") continue;
    if (stroke.material.empty()) reader.refuse("nothing beside \"paint\"", "a key of \"materials\"");
    const bool known = std::find(materials.begin(), materials.end(), stroke.material) != materials.end();
    if (!stroke.material.empty() && !known)
      reader.refuse(quoted_excerpt(stroke.material), suggest(stroke.material, materials));
  }
}

/// Where in an event a problem of the edited scene comes from: the edit at or above it, or the last one.
std::string blame(const Event& event, const std::string& pointer) {
  for (const Edit& edit : event.set) {
    if (is_at_or_below(pointer, edit.pointer) || is_at_or_below(edit.pointer, pointer)) return edit.pointer;
  }
  return event.set.back().pointer;
}

}  // namespace

Constants read_constants(Reader& reader, const Json& json) {
  Constants constants;
  if (!json.is_object()) {
    reader.refuse(describe(json), "an object { \"name\": number, ... }");
    return constants;
  }
  if (!check_count(reader, json.size(), most_constants, "constants")) return constants;
  for (const auto& [name, value] : json.items()) {
    const Reader::Step step(reader, name);
    if (!is_identifier(name)) {
      reader.refuse("the name " + quoted_excerpt(name), "letters, digits and _, not beginning with a digit");
    } else if (is_reserved(name)) {
      reader.refuse("the name " + quoted_excerpt(name) + ", which has a meaning in expressions", "another name");
    } else if (!value.is_number()) {
      reader.refuse(describe(value), "a number");
    } else if (std::abs(value.get<double>()) > largest_constant) {
      reader.refuse(describe(value), "numbers up to 1e300");
    } else if (std::isfinite(value.get<double>())) {  // a NaN has been reported by read_json
      constants.emplace_back(name, value.get<double>());
    }
  }
  return constants;
}

void check_scene(Reader& reader, const Scene& scene, const Json& document) {
  check_references(reader, scene);
  check_colors(reader, scene.view);
  check_exact(reader, scene, document);
  if (scene.transfer.type == "apic" && scene.transfer.velocity_mass == "consistent") {
    reader.refuse("/transfer/velocity_mass", "\"consistent\" beside \"apic\"",
                  "\"lumped\": APIC with the consistent velocity transfer is unstable. \"integrator\": { \"mass\": "
                  "\"consistent\" } is "
                  "allowed with apic");
  }
  if (scene.transfer.type == "fmpm" && scene.transfer.velocity_mass == "consistent")
    reader.refuse(
        "/transfer/velocity_mass", "\"consistent\" beside \"fmpm\"",
        "\"lumped\": fmpm goes from there towards the consistent velocity transfer by its \"order\". \"pic\" with "
        "\"consistent\" is where it would end");
  check_integrator(reader, scene);
  // Beside "fixed" it waits to be used again; without a word on control it was forgotten.
  if (scene.time.tolerance && !document["time"].contains("control"))
    reader.refuse("/time/tolerance", "a tolerance without \"control\"", "\"control\": \"adaptive\" beside it");
  if (scene.time.end / scene.time.step > most_steps)
    reader.refuse("/time/step", number_text(scene.time.end / scene.time.step) + " steps until \"end\"",
                  "at most 1e9 steps");
}

void check_events(Reader& reader, const Scene& scene, const Json& document) {
  if (scene.events.empty()) return;
  Json edited = without_events(document);
  const Reader::Step list(reader, "events");
  const double work = static_cast<double>(count_values(edited)) * static_cast<double>(scene.events.size());
  if (work > most_event_work)
    return reader.refuse(std::to_string(scene.events.size()) + " events on a scene this large",
                         "fewer events, or a smaller scene");
  std::vector<std::size_t> order(scene.events.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return scene.events[a].time < scene.events[b].time; });
  for (const std::size_t k : order) {
    const Event& event = scene.events[k];
    const Reader::Step at(reader, k);
    if (event.set.empty() && event.strokes.empty())
      reader.refuse("an event that does nothing", "\"set\", \"strokes\", or both");
    check_strokes(reader, scene, event);
    if (event.set.empty()) continue;
    const Reader::Step set(reader, "set");
    if (!apply_event(reader, event, edited)) return;
    Reader inner(reader.dimension(), {});
    read_scene(inner, edited, false);
    if (inner.refused() == 0) continue;
    for (const Problem& problem : inner.take_problems()) {
      const Reader::Step step(reader, blame(event, problem.pointer));
      reader.refuse(problem.found, problem.allowed);
    }
    return;  // later events would only repeat it
  }
}

}  // namespace pf
