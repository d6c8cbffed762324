#include "core/studies/study_tables.hpp"

#include "core/scene/key_builder.hpp"
#include "core/studies/row.hpp"

namespace pf {
namespace {

constexpr std::size_t most_charts = 50, most_limits = 50, most_checks = 200;

/// A row for a member of Study inside StudyDocument.
template <class Member>
auto of_study(Member Study::*member) {
  return [member](StudyDocument& d) -> Member& { return d.study.*member; };
}

template <class Get>
Row text_of(TableOf<StudyDocument>& t, Get get, const std::string& key, const std::string& label) {
  return t.leaf(
      SettingKind::text, key, label, "",
      [get](Reader& r, const Json& j, const Setting& s, StudyDocument& d) { return read_text(r, j, s, get(d)); },
      [](const StudyDocument&, const WriteStyle&) { return std::optional<Json>(); });
}
template <class Get>
Row number_of(TableOf<StudyDocument>& t, Get get, const std::string& key, const std::string& label,
              const std::string& unit) {
  return t.leaf(
      SettingKind::number, key, label, unit,
      [get](Reader& r, const Json& j, const Setting& s, StudyDocument& d) { return read_number(r, j, s, get(d)); },
      [](const StudyDocument&, const WriteStyle&) { return std::optional<Json>(); });
}
template <class Get>
Row integer_of(TableOf<StudyDocument>& t, Get get, const std::string& key, const std::string& label) {
  return t.leaf(
      SettingKind::integer, key, label, "",
      [get](Reader& r, const Json& j, const Setting& s, StudyDocument& d) {
        std::uint64_t value = 0;
        const bool good = read_integer(r, j, s, value);
        if (good) get(d) = static_cast<int>(value);
        return good;
      },
      [](const StudyDocument&, const WriteStyle&) { return std::optional<Json>(); });
}
template <class Get>
Row choice_of(TableOf<StudyDocument>& t, Get get, const std::string& key, const std::string& label) {
  return t.leaf(
      SettingKind::choice, key, label, "",
      [get](Reader& r, const Json& j, const Setting& s, StudyDocument& d) {
        std::string value;
        const bool good = read_choice(r, j, s, value);
        if (good) get(d, value);
        return good;
      },
      [](const StudyDocument&, const WriteStyle&) { return std::optional<Json>(); });
}

void add_header(TableOf<StudyDocument>& t) {
  const auto nothing = [](const StudyDocument&, const WriteStyle&) { return std::optional<Json>(); };
  t.leaf(
      SettingKind::text, "format", "Format", "",
      [](Reader& r, const Json& j, const Setting&, StudyDocument&) {
        if (j != "pushforward/study") r.refuse(describe(j), "\"pushforward/study\"");
        return true;
      },
      nothing);
  t.leaf(
      SettingKind::integer, "version", "Version", "",
      [](Reader& r, const Json& j, const Setting&, StudyDocument&) {
        const bool newer = j.is_number() && j.get<double>() > 1;
        if (j != 1) r.refuse(describe(j), newer ? "1: this file was written for a newer program" : "1");
        return true;
      },
      nothing);
}

void read_edits(Reader& reader, const Json& json, std::vector<Edit>& edits) {
  if (!json.is_object()) return reader.refuse(describe(json), "an object { \"/pointer\": value, ... }");
  for (const auto& [pointer, value] : json.items()) {
    const Reader::Step step(reader, pointer);
    if (!pointer.starts_with('/'))
      reader.refuse("the key \"" + pointer + "\"", "pointers into the scene, for instance /time/step");
    else
      edits.push_back({pointer, nlohmann::json(value)});
  }
}

void read_titles(Reader& reader, const Json& json, std::vector<std::pair<std::string, std::string>>& titles) {
  if (!json.is_object()) return reader.refuse(describe(json), "an object { \"column\": \"Title [unit]\", ... }");
  for (const auto& [column, title] : json.items()) {
    const Reader::Step step(reader, column);
    if (title.is_string())
      titles.emplace_back(column, title.get<std::string>());
    else
      reader.refuse(describe(title), "a text such as \"Time step [s]\"");
  }
}

/// A key that is only kept: what it means needs the scene.
void keep(TableOf<StudyDocument>& t, Json StudyDocument::*member, const std::string& key, const std::string& label,
          bool required) {
  Key& row = t.own(Nesting::leaf, nullptr, key, label);
  row.setting.required = required;
  row.read = [member](Reader&, const Json& j, void* o) { static_cast<StudyDocument*>(o)->*member = j; };
  row.write = [](const void*, const WriteStyle&) { return std::optional<Json>(); };
}

const Table& threshold_table() {
  static const Table table = [] {
    TableOf<StudyThresholds> t("Thresholds");
    t.number(&StudyThresholds::growing, "growing", "Energy gained above which a run is growing", "").at_least(0);
    t.number(&StudyThresholds::blown_up, "blown_up", "Energy gained above which a run has blown up", "").above(0);
    t.number(&StudyThresholds::noisy, "noisy", "Stress noise above which a run is noisy", "").at_least(0);
    t.number(&StudyThresholds::damped, "damped", "Energy lost above which a run is damped", "").at_least(0);
    return t.take();
  }();
  return table;
}

const Table& chart_table() {
  static const Table table = [] {
    TableOf<StudyChart> t("Chart");
    t.text(&StudyChart::name, "name", "Name of its files");
    t.text(&StudyChart::title, "title", "Title");
    t.text(&StudyChart::subtitle, "subtitle", "Line below the title");
    t.text(&StudyChart::x, "x", "Column or varied pointer, or \"cost\"").at_least(1);
    t.text(&StudyChart::y, "y", "Column or varied pointer, or \"cost\"").at_least(1);
    t.text(&StudyChart::lines, "lines", "Column that tells the lines apart");
    t.flag(&StudyChart::fit, "fit", "Fit orders");
    t.flag(&StudyChart::pareto, "pareto", "Mark the Pareto front");
    t.leaf(
        SettingKind::vector, "slopes", "Slope triangles", "",
        [](Reader& r, const Json& j, const Setting&, StudyChart& chart) {
          if (!j.is_array() || j.size() > 8) return r.refuse(describe(j), "an array of at most 8 numbers"), false;
          for (std::size_t k = 0; k < j.size(); ++k) {
            const Reader::Step step(r, k);
            if (!j[k].is_number() || j[k] == 0) return r.refuse(describe(j[k]), "a number that is not 0"), false;
            chart.slopes.push_back(j[k].get<double>());
          }
          return true;
        },
        [](const StudyChart&, const WriteStyle&) { return std::optional<Json>(); });
    return t.take();
  }();
  return table;
}

const Table& limit_table() {
  static const Table table = [] {
    TableOf<StudyLimit> t("Limit");
    t.text(&StudyLimit::label, "label", "Name").required().at_least(1);
    t.text(&StudyLimit::y, "y", "Vertical value, an expression in x");
    t.text(&StudyLimit::x, "x", "Horizontal value, an expression in y");
    return t.take();
  }();
  return table;
}

const Table& check_table() {
  static const Table table = [] {
    TableOf<StudyCheck> t("Check");
    t.text(&StudyCheck::name, "name", "What is checked").required().at_least(1);
    t.text(&StudyCheck::of, "of", "Column of numbers").at_least(1);
    t.number(&StudyCheck::per, "per", "What it is divided by", "").above(0);
    t.number(&StudyCheck::exact, "exact", "Exact value: what is judged is the distance from it", "");
    t.text(&StudyCheck::order_in, "order_in", "Column in whose powers the numbers fall: what is judged is the order");
    t.choice(&StudyCheck::rows, "rows", "Which rows").choices({"last", "all"});
    t.number(&StudyCheck::above, "above", "Lower bound", "");
    t.number(&StudyCheck::below, "below", "Upper bound", "");
    t.text(&StudyCheck::peer, "peer", "What the best peer reaches");
    Key& where = t.own(Nesting::map, nullptr, "where", "Values of varied columns");
    where.read = [](Reader& r, const Json& j, void* o) {
      if (!j.is_object()) return r.refuse(describe(j), "an object { \"column\": value, ... }");
      static_cast<StudyCheck*>(o)->where = nlohmann::json(j);
    };
    where.write = [](const void*, const WriteStyle&) { return std::optional<Json>(); };
    return t.take();
  }();
  return table;
}

/// A list or object inside Study.
template <class Read>
void nested(TableOf<StudyDocument>& t, const Table& (*child)(), const std::string& key, const std::string& label,
            Read read) {
  Key& row = t.own(Nesting::object, child, key, label);
  row.read = read;
  row.write = [](const void*, const WriteStyle&) { return std::optional<Json>(); };
}

template <class Item>
void read_list(Reader& r, const Json& j, const Table& table, std::size_t most, std::vector<Item>& items) {
  if (!j.is_array() || j.size() > most)
    return r.refuse(describe(j), "an array of at most " + std::to_string(most) + " objects");
  items.resize(j.size());
  for (std::size_t k = 0; k < j.size(); ++k) {
    const Reader::Step step(r, k);
    read_table(r, table, j[k], &items[k]);
  }
}

}  // namespace

const Table& study_table() {
  static const Table table = [] {
    TableOf<StudyDocument> t("Study");
    add_header(t);
    text_of(t, of_study(&Study::name), "name", "Name");
    text_of(t, of_study(&Study::about), "about", "About");
    keep(t, &StudyDocument::scene, "scene", "Scene", true);
    Key& set = t.own(Nesting::map, nullptr, "set", "Overrides of every run");
    set.read = [](Reader& r, const Json& j, void* o) { read_edits(r, j, static_cast<StudyDocument*>(o)->study.set); };
    set.write = [](const void*, const WriteStyle&) { return std::optional<Json>(); };
    choice_of(
        t,
        [](StudyDocument& d, const std::string& kind) {
          d.study.kind = kind == "stability_map" ? StudyKind::stability_map : StudyKind::work_precision;
        },
        "kind", "Kind")
        .choices({"work_precision", "stability_map"});
    keep(t, &StudyDocument::vary, "vary", "What is varied", true);
    keep(t, &StudyDocument::reference, "reference", "Reference", false);
    choice_of(
        t, [](StudyDocument& d, const std::string& cost) { d.study.cost = cost; }, "cost", "Cost")
        .choices({"wall", "work"});
    integer_of(t, of_study(&Study::repeat), "repeat", "Timed runs of each setting").at_least(1).at_most(1000);
    number_of(t, of_study(&Study::timeout_s), "timeout_s", "Longest run", "s").above(0).at_most(1e7);
    integer_of(t, of_study(&Study::threads), "threads", "Threads of a run").at_least(1).at_most(1024);
    integer_of(t, of_study(&Study::samples), "samples", "Times of comparison").at_least(1).at_most(10000);
    nested(t, threshold_table, "thresholds", "Thresholds", [](Reader& r, const Json& j, void* o) {
      read_table(r, threshold_table(), j, &static_cast<StudyDocument*>(o)->study.thresholds);
    });
    Key& titles = t.own(Nesting::map, nullptr, "titles", "Titles of columns in charts");
    titles.read = [](Reader& r, const Json& j, void* o) {
      read_titles(r, j, static_cast<StudyDocument*>(o)->study.titles);
    };
    titles.write = [](const void*, const WriteStyle&) { return std::optional<Json>(); };
    text_of(t, of_study(&Study::along), "along", "What changes along a line");
    choice_of(
        t, [](StudyDocument& d, const std::string& name) { d.study.measure = name; }, "measure", "What colours a map")
        .choices(row_column_names());
    nested(t, chart_table, "charts", "Charts", [](Reader& r, const Json& j, void* o) {
      read_list(r, j, chart_table(), most_charts, static_cast<StudyDocument*>(o)->study.charts);
    });
    nested(t, limit_table, "limits", "Limits drawn over a map", [](Reader& r, const Json& j, void* o) {
      read_list(r, j, limit_table(), most_limits, static_cast<StudyDocument*>(o)->study.limits);
    });
    nested(t, check_table, "checks", "What must come out", [](Reader& r, const Json& j, void* o) {
      read_list(r, j, check_table(), most_checks, static_cast<StudyDocument*>(o)->study.checks);
    });
    text_of(t, of_study(&Study::reference_text), "source", "Where the answer comes from");
    Key& quick = t.own(Nesting::leaf, nullptr, "quick", "Part of every test run");
    quick.read = [](Reader& r, const Json& j, void* o) {
      if (!j.is_boolean()) return r.refuse(describe(j), "true or false");
      static_cast<StudyDocument*>(o)->study.quick = j.get<bool>();
    };
    quick.write = [](const void*, const WriteStyle&) { return std::optional<Json>(); };
    return t.take();
  }();
  return table;
}

}  // namespace pf
