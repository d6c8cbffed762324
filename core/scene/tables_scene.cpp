// The table of the whole scene file, and of events.
#include "core/scene/key_builder.hpp"
#include "core/scene/tables.hpp"

namespace pf {
namespace {

constexpr std::size_t most_bodies = 10'000, most_boundaries = 1'000, most_constraints = 1'000, most_loads = 1'000,
                      most_probes = 10'000, most_events = 100'000, most_strokes = 1'000;

/// "format" and "version" say what the file is; the scene does not keep them.
void add_header(TableOf<Scene>& t) {
  t.leaf(
       SettingKind::text, "format", "Format", "",
       [](Reader& r, const Json& j, const Setting&, Scene&) {
         if (j != "pushforward/scene") r.refuse(describe(j), "\"pushforward/scene\"");
         return j == "pushforward/scene";
       },
       [](const Scene&, const WriteStyle&) { return Json("pushforward/scene"); })
      .reset()
      .help("What kind of file this is: \"pushforward/scene\".");
  t.leaf(
       SettingKind::integer, "version", "Version", "",
       [](Reader& r, const Json& j, const Setting&, Scene&) {
         const bool good = j.is_number() && j.get<double>() == 1;
         const bool newer = j.is_number() && j.get<double>() > 1;
         if (!good) r.refuse(describe(j), newer ? "1: this file was written for a newer program" : "1");
         return good;
       },
       [](const Scene&, const WriteStyle&) { return Json(1); })
      .at_least(1)
      .at_most(1)
      .reset()
      .help("Of the format. Older versions are read for ever.");
}

void add_dimension(TableOf<Scene>& t) {
  t.leaf(
       SettingKind::integer, "dimension", "Dimension", "",
       [](Reader& r, const Json& j, const Setting&, Scene& o) {
         const bool good = j.is_number() && (j.get<double>() == 2 || j.get<double>() == 3);
         if (good) o.dimension = j.get<int>();
         if (!good) r.refuse(describe(j), "2 (plane strain) or 3");
         return good;
       },
       [](const Scene& o, const WriteStyle&) { return Json(o.dimension); })
      .at_least(2)
      .at_most(3)
      .required()
      .reset()
      .help("2 (plane strain, unit thickness) or 3. Every vector of the file has this many components.");
}

const Table& constant_table() {
  static const Table table = [] {
    TableOf<Formula> t("Constants");  // one row for every name
    t.number(&Formula::number, "*", "Constant", "")
        .within(largest_constant)
        .slider(-10, 10)
        .reset()
        .help("A name for use in expressions.");
    return t.take();
  }();
  return table;
}

void add_constants(TableOf<Scene>& t) {
  Key& row = t.own(Nesting::map, constant_table, "constants", "Constants");
  row.setting.help = "Names for use in expressions.";
  row.read = [](Reader& r, const Json& j, void* o) { static_cast<Scene*>(o)->constants = read_constants(r, j); };
  row.write = [](const void* o, const WriteStyle&) {
    Json object = Json::object();
    for (const auto& [name, value] : static_cast<const Scene*>(o)->constants) object[name] = value;
    return object;
  };
}

void add_materials(TableOf<Scene>& t) {
  Key& row = t.own(Nesting::map, material_table, "materials", "Materials");
  row.setting.required = true;
  row.setting.help = "By name; bodies refer to them.";
  row.read = [](Reader& r, const Json& j, void* o) { read_materials(r, j, static_cast<Scene*>(o)->materials); };
  row.write = [](const void* o, const WriteStyle& style) {
    return write_materials(static_cast<const Scene*>(o)->materials, style.defaults);
  };
}

/// {"position": [...]}: the only key of "exact".
const Table& exact_table() {
  static const Table table = [] {
    TableOf<Scene> t("Exact motion");
    t.formulas(&Scene::exact_position, mask_reference_time, true, "position", "Known motion", "m")
        .within(1e9)
        .slider(-10, 10)
        .required()
        .reset()
        .help(
            "Position as a function of reference position X Y Z and time t. Errors are measured against it; it also "
            "gives the initial velocity and deformation.");
    return t.take();
  }();
  return table;
}

void add_exact(TableOf<Scene>& t) {
  Key& row = t.own(Nesting::object, exact_table, "exact", "Exact motion");
  row.setting.applies = Applies::reset;
  row.setting.help = "The motion, where it is known.";
  row.read = [](Reader& r, const Json& j, void* o) { read_table(r, exact_table(), j, o); };
  row.write = [](const void* o, const WriteStyle& style) {
    if (static_cast<const Scene*>(o)->exact_position.empty()) return std::optional<Json>();
    return std::optional<Json>(write_table(exact_table(), o, style));
  };
}

void read_event_edits(Reader& reader, const Json& json, std::vector<Edit>& edits) {
  if (!json.is_object()) return reader.refuse(describe(json), "an object { \"/pointer\": value, ... }");
  if (json.empty()) reader.refuse("no edit", "at least one \"/pointer\": value");
  for (const auto& [pointer, value] : json.items()) edits.push_back({pointer, nlohmann::json(value)});
}

}  // namespace

const Table& event_table() {
  static const Table table = [] {
    TableOf<Event> t("Event");
    t.number(&Event::time, "time", "Time", "s")
        .at_least(0)
        .at_most(1e9)
        .slider(0, 10)
        .required()
        .reset()
        .help("Applied at the first step at or after this time.");
    Key& row = t.own(Nesting::map, nullptr, "set", "Edits");
    row.setting.help = "Pointers into the scene and their new values; only settings that apply live.";
    row.read = [](Reader& r, const Json& j, void* o) { read_event_edits(r, j, static_cast<Event*>(o)->set); };
    row.write = [](const void* o, const WriteStyle&) {
      Json object = Json::object();
      for (const Edit& edit : static_cast<const Event*>(o)->set) object[edit.pointer] = Json(edit.value);
      return object.empty() ? std::nullopt : std::optional<Json>(object);
    };
    row.schema = [] { return Json{{"type", "object"}, {"minProperties", 1}, {"propertyNames", {{"pattern", "^/"}}}}; };
    t.list(&Event::strokes, stroke_table, 1, most_strokes, "strokes", "Strokes")
        .help("Cuts and paints the material, after the edits, one after the other.");
    Key& strokes = t.last();
    strokes.write = [all = strokes.write](const void* o, const WriteStyle& style) {
      return static_cast<const Event*>(o)->strokes.empty() ? std::nullopt : all(o, style);
    };
    return t.take();
  }();
  return table;
}

const Table& scene_table() {
  static const Table table = [] {
    TableOf<Scene> t("Scene");
    add_header(t);
    t.text(&Scene::name, "name", "Name").view().help("The scene's title.");
    t.text(&Scene::about, "about", "About").view().help("One or two sentences shown in the app.");
    add_dimension(t);
    add_constants(t);
    t.vector(&Scene::gravity, "gravity", "Gravity", "m/s^2")
        .within(1e9)
        .slider(-20, 20)
        .live()
        .help("Acceleration of every particle; [0, -9.81] is the earth's in 2D.");
    t.formulas(&Scene::body_force, mask_all, true, "body_force", "Body force", "m/s^2")
        .within(1e9)
        .slider(-20, 20)
        .live()
        .help("Extra acceleration, as a function of reference position X Y Z, current position x y z and time t.");
    t.object(&Scene::grid, grid_table, "grid", "Grid").required();
    t.object(&Scene::time, time_table, "time", "Time");
    t.object(&Scene::integrator, integrator_table, "integrator", "Time integration");
    t.object(&Scene::transfer, transfer_table, "transfer", "Transfer");
    t.object(&Scene::solver, solver_table, "solver", "Solver");
    add_materials(t);
    t.list(&Scene::bodies, body_table, 1, most_bodies, "bodies", "Bodies").required();
    t.list(&Scene::boundaries, boundary_table, 0, most_boundaries, "boundaries", "Boundaries");
    t.list(&Scene::constraints, constraint_table, 0, most_constraints, "constraints", "Constraints");
    t.list(&Scene::loads, load_table, 0, most_loads, "loads", "Loads");
    add_exact(t);
    t.flag(&Scene::manufactured, "manufactured", "Manufactured solution")
        .reset()
        .help("Derive the body force, the surface traction and the initial state that make \"exact\" the solution.");
    t.list(&Scene::probes, probe_table, 0, most_probes, "probes", "Probes");
    t.list(&Scene::events, event_table, 0, most_events, "events", "Events");
    t.object(&Scene::view, view_table, "view", "View");
    return t.take();
  }();
  return table;
}

}  // namespace pf
