// Every shipped lesson is played through: values set, conditions waited for, claims and answers checked.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <set>

#include "app/lessons/measures.hpp"
#include "app/lessons/rehearse.hpp"
#include "core/assets.hpp"

using namespace pf;
using namespace pf::app;
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> lesson_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(asset_path("lessons")))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  return files;
}

constexpr const char* tiny = R"({"format": "pushforward/lesson", "version": 1, "title": "T", "about": "A", "pages": [
  {"title": "P", "scene": {"dimension": 2, "grid": {"spacing": 0.1}, "gravity": [0, -10],
     "materials": {"m": {"model": "neo_hookean", "density": 1000, "young": 1e5, "poisson": 0.3}},
     "bodies": [{"material": "m", "shape": {"type": "box", "min": [0, 0], "max": [0.2, 0.2]}}]},
   "text": ["It falls at {momentum/40|m/s}.", "$x_p"], "until": "time >= 0.1", "say": "Wait.",
   "keep": {"speed": "momentum/40"}, "holds": ["abs(speed - 1) < 1e-6"],
   "question": {"text": "?", "choices": ["a", "b"], "replies": ["no", "yes"], "answer": 1, "because": "speed > 0.5"}}]})";

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("there are ten lessons, in order") {
  const std::vector<Lesson> lessons = shipped_lessons();
  CHECK(lessons.size() == lesson_files().size());
  REQUIRE(lessons.size() == 10);
  for (std::size_t k = 0; k < lessons.size(); ++k) {
    CHECK(lessons[k].order == static_cast<int>(k) + 1);
    CHECK(lessons[k].pages.size() >= 3);
  }
}

TEST_CASE("every lesson comes out as it says") {
  const char* chosen = std::getenv("PUSHFORWARD_LESSON");  // one of them, with what it measures
  for (const fs::path& file : lesson_files()) {
    if (chosen != nullptr && file.stem().string().find(chosen) == std::string::npos) continue;
    CAPTURE(file.string());
    const Lesson lesson = load_lesson(file);
    const auto tell = [&](std::size_t page, const Constants& values) {
      if (chosen == nullptr) return;
      std::cout << "page " << page + 1 << ":";
      for (const auto& [name, value] : values) std::cout << ' ' << name << '=' << value;
      std::cout << '\n';
    };
    const Rehearsal rehearsal = rehearse(lesson, tell);
    for (const std::string& problem : rehearsal.problems) FAIL_CHECK(problem);
    CHECK(rehearsal.steps < 6000);  // a lesson is not a batch job
  }
}

TEST_CASE("a rehearsal measures, and complains of what does not hold") {
  const Rehearsal good = rehearse(parse_lesson(tiny, "tiny"));
  CHECK(good.problems.empty());
  REQUIRE(good.kept.size() == 1);
  CHECK(good.kept[0].second == doctest::Approx(1).epsilon(1e-6));

  const auto trouble = [](const std::string& text) { return rehearse(parse_lesson(text, "tiny")).problems; };
  CHECK(trouble(with(tiny, "abs(speed - 1) < 1e-6", "speed > 2")).size() == 1);
  CHECK(trouble(with(tiny, "time >= 0.1", "momentum < 0")).front().find("never came true") != std::string::npos);
  CHECK(trouble(with(tiny, "speed > 0.5\"", "speed > 5\"")).size() == 1);
  CHECK(trouble(with(tiny, "{momentum/40|m/s}", "{momentun/40|m/s}")).size() == 1);
  CHECK(trouble(with(tiny, "\"until\"", R"("task": {"/grid/spacing": -1}, "until")")).size() == 1);
}

TEST_CASE("a lesson that is written wrongly says where") {
  const auto pointers = [](const std::string& text) {
    std::set<std::string> found;
    try {
      parse_lesson(text, "tiny");
    } catch (const InputError& error) {
      for (const Problem& p : error.problems()) found.insert(p.pointer);
    }
    return found;
  };
  CHECK(pointers(tiny).empty());
  CHECK(pointers(with(tiny, "\"keep\"", "\"kept\"")).contains("/pages/0/kept"));
  CHECK(pointers(with(tiny, "$x_p", "$\\\\nonsense")).contains("/pages/0/text"));
  CHECK(pointers(with(tiny, "\"answer\": 1", "\"answer\": 2")).contains("/pages/0/question/answer"));
  CHECK(pointers(with(tiny, "\"spacing\": 0.1", "\"spacing\": 0")).contains("/pages/0/scene"));
  CHECK(pointers(with(tiny, "\"until\"", R"("highlight": "/nothing", "until")")).contains("/pages/0/highlight"));
  CHECK(pointers(with(tiny, "pushforward/lesson", "pushforward/scene")).contains("/format"));
}

TEST_CASE("values in texts and pieces of material are what they are") {
  const Constants values{{"a", 0.1234}, {"b", 2}};
  CHECK(with_values("{100*a|%} of {b|m}, {a}", values) == "12.3 % of 2 m, 0.123");
  CHECK(measured("a < b && b == 2", values) == 1);
  CHECK_THROWS_AS(with_values("{c}", values), ExpressionError);
  Snapshot s;
  s.dimension = 2;
  s.spacing = 1;
  s.particles = 3;
  s.x = {0.5, 0.5, 1.5, 1.5, 3.5, 0.5};
  const BasisInfo &linear = *find_basis("linear"), &quadratic = *find_basis("quadratic");
  CHECK(count_pieces(s, linear) == 2);
  CHECK(count_pieces(s, quadratic) == 1);  // its functions reach further
  s.x[4] = 2.5;
  CHECK(count_pieces(s, linear) == 1);
  s.x[4] = 5.5;
  CHECK(count_pieces(s, quadratic) == 2);
}

TEST_CASE("every measure has a value and a name of its own") {
  RunMeasures run;
  run.add(StepReport{});
  Scene scene;
  const Constants values = run.values(scene, nullptr);
  CHECK(values.size() == measure_infos().size());
  std::set<std::string> names;
  for (const auto& [name, value] : values) CHECK(names.insert(name).second);
}
