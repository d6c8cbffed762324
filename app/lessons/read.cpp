#include <algorithm>
#include <array>
#include <functional>

#include "app/formula/formula.hpp"
#include "app/lessons/lesson.hpp"
#include "core/assets.hpp"
#include "core/diagnostics/fields.hpp"
#include "core/files.hpp"
#include "core/params/json_reader.hpp"
#include "core/params/pointer.hpp"
#include "core/params/setting.hpp"

namespace pf::app {

namespace {

/// Reads one object: every key is looked for once, what is left over is a problem.
class Reader {
 public:
  Reader(const Json& value, std::string pointer, std::vector<Problem>& problems)
      : value_(value), pointer_(std::move(pointer)), problems_(problems) {
    if (!value_.is_object()) add("", describe(value_), "an object");
  }
  ~Reader() {
    if (!value_.is_object()) return;
    for (const auto& [key, value] : value_.items())
      if (std::find(known_.begin(), known_.end(), key) == known_.end())
        add(key, "an unknown key", "one of those of a lesson: docs/lessons.md");
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  const Json* find(const char* key) {
    known_.emplace_back(key);
    if (!value_.is_object()) return nullptr;
    const auto it = value_.find(key);
    return it == value_.end() ? nullptr : &*it;
  }
  void text(const char* key, std::string& to, bool required = false) {
    const Json* v = find(key);
    if (v != nullptr && v->is_string())
      to = v->get<std::string>();
    else if (v != nullptr || required)
      add(key, v ? describe(*v) : "nothing", "a text");
  }
  template <class Number>
  void number(const char* key, Number& to) {
    const Json* v = find(key);
    if (v == nullptr) return;
    if (v->is_number())
      to = v->get<Number>();
    else
      add(key, describe(*v), "a number");
  }
  template <class Flag>
  void flag(const char* key, Flag& to) {
    const Json* v = find(key);
    if (v == nullptr) return;
    if (v->is_boolean())
      to = v->get<bool>();
    else
      add(key, describe(*v), "true or false");
  }
  void texts(const char* key, std::vector<std::string>& to) {
    const Json* v = find(key);
    if (v == nullptr) return;
    if (v->is_string()) {
      to.push_back(v->get<std::string>());
      return;
    }
    if (!v->is_array()) return add(key, describe(*v), "an array of texts");
    for (const Json& t : *v)
      if (t.is_string())
        to.push_back(t.get<std::string>());
      else
        add(key, describe(t), "a text");
  }
  void edits(const char* key, std::vector<Edit>& to) {
    const Json* v = find(key);
    if (v == nullptr) return;
    if (!v->is_object()) return add(key, describe(*v), "an object of pointers into the scene and their values");
    for (const auto& [pointer, value] : v->items()) to.push_back({pointer, nlohmann::json(value)});
  }
  void add(const std::string& key, const std::string& found, const std::string& allowed) {
    problems_.push_back({key.empty() ? pointer_ : pointer_ + pointer_step(key), found, allowed});
  }

 private:
  const Json& value_;
  std::string pointer_;
  std::vector<Problem>& problems_;
  std::vector<std::string> known_;
};

void read_lines(Reader& r, LessonPage& page) {
  std::vector<std::string> texts;
  r.texts("text", texts);
  for (const std::string& text : texts) {
    const bool formula = text.starts_with("$");
    page.lines.push_back({formula, formula ? text.substr(1) : text});
    if (!formula) continue;
    try {
      Formula::parse(page.lines.back().text);
    } catch (const FormulaError& error) {
      r.add("text", error.what(), "a formula");
    }
  }
}

void read_view(const Json* value, const std::string& pointer, LessonView& view, std::vector<Problem>& problems) {
  if (value == nullptr) return;
  Reader r(*value, pointer + "/view", problems);
  r.text("field", view.field);
  r.text("plot", view.plot);
  r.flag("grid", view.grid);
  r.flag("bent_grid", view.bent_grid);
  r.flag("velocities", view.velocities);
  r.flag("shapes", view.shapes);
  if (!view.field.empty() && find_field(view.field) == nullptr) r.add("field", view.field, "the name of a field");
}

void read_question(const Json* value, const std::string& pointer, LessonPage& page, std::vector<Problem>& problems) {
  if (value == nullptr) return;
  LessonQuestion q;
  Reader r(*value, pointer + "/question", problems);
  r.text("text", q.text, true);
  r.texts("choices", q.choices);
  r.texts("replies", q.replies);
  r.number("answer", q.answer);
  r.text("because", q.because);
  if (q.choices.size() < 2) r.add("choices", std::to_string(q.choices.size()), "at least two");
  if (q.replies.size() != q.choices.size()) r.add("replies", std::to_string(q.replies.size()), "one a choice");
  if (q.answer >= q.choices.size()) r.add("answer", std::to_string(q.answer), "the index of a choice");
  page.question = std::move(q);
}

void read_scene(Reader& r, LessonPage& page) {
  const Json* v = r.find("scene");
  if (v == nullptr) return;
  try {
    if (v->is_string())
      page.scene = load_scene(asset_path("scenes/" + v->get<std::string>() + ".json"));
    else
      page.scene = parse_scene(v->dump(), "the lesson's scene");
  } catch (const InputError& error) {
    for (const Problem& p : error.problems()) r.add("scene", to_string(p), "a scene");
  } catch (const FileError& error) {
    r.add("scene", error.what(), "the name of a shipped scene, or a scene");
  }
}

LessonPage read_page(const Json& value, const std::string& pointer, std::vector<Problem>& problems) {
  LessonPage page;
  Reader r(value, pointer, problems);
  r.text("title", page.title, true);
  read_lines(r, page);
  read_scene(r, page);
  r.edits("set", page.set);
  r.flag("restart", page.restart);
  r.flag("run", page.run);
  r.text("highlight", page.highlight);
  if (!page.highlight.empty() && find_setting(page.highlight) == nullptr)
    r.add("highlight", page.highlight, "the pointer of a setting");
  r.edits("task", page.task);
  r.flag("slow", page.slow);
  r.text("until", page.until);
  r.text("say", page.say);
  r.number("limit", page.limit);
  r.texts("holds", page.holds);
  if (const Json* keep = r.find("keep"); keep != nullptr && keep->is_object())
    for (const auto& [name, text] : keep->items())
      page.keep.emplace_back(name, text.is_string() ? text.get<std::string>() : text.dump());
  read_view(r.find("view"), pointer, page.view, problems);
  read_question(r.find("question"), pointer, page, problems);
  if (!page.until.empty() && page.say.empty()) r.add("say", "nothing", "what the reader is to wait for");
  return page;
}

}  // namespace

Lesson parse_lesson(std::string_view text, const std::string& source) {
  std::vector<Problem> problems;
  const Json json = read_json(text, source, problems);
  Lesson lesson;
  {
    Reader r(json, "", problems);
    std::string format;
    int version = 1;
    r.text("format", format);
    r.number("version", version);
    if (format != "pushforward/lesson") r.add("format", format, "pushforward/lesson");
    if (version != 1) r.add("version", std::to_string(version), "1");
    r.text("title", lesson.title, true);
    r.text("about", lesson.about, true);
    r.number("order", lesson.order);
    r.number("minutes", lesson.minutes);
    const Json* pages = r.find("pages");
    if (pages == nullptr || !pages->is_array() || pages->empty())
      r.add("pages", pages ? describe(*pages) : "nothing", "an array of pages");
    else
      for (std::size_t k = 0; k < pages->size(); ++k)
        lesson.pages.push_back(read_page((*pages)[k], "/pages/" + std::to_string(k), problems));
    if (!lesson.pages.empty() && !lesson.pages[0].scene) r.add("pages", "a first page without a scene", "one with it");
  }
  if (!problems.empty()) throw InputError(source, std::move(problems));
  return lesson;
}

Lesson load_lesson(const std::filesystem::path& file) {
  Lesson lesson = parse_lesson(read_file(file), file.string());
  lesson.file = file;
  return lesson;
}

std::vector<Lesson> shipped_lessons() {
  std::vector<Lesson> found;
  try {
    for (const auto& entry : std::filesystem::directory_iterator(asset_path("lessons"))) {
      if (entry.path().extension() != ".json") continue;
      try {
        found.push_back(load_lesson(entry.path()));
      } catch (const std::exception&) {
        continue;  // a test names it; the others are still worth having
      }
    }
  } catch (const FileError&) {
    return found;
  }
  std::sort(found.begin(), found.end(), [](const Lesson& a, const Lesson& b) { return a.order < b.order; });
  return found;
}

}  // namespace pf::app
