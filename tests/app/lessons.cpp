// Lessons in the window: pages open scenes, tasks and conditions are noticed, answers checked, values shown.
#include "app/lessons/lesson.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include "app/lessons/desk.hpp"
#include "app/panels/memory.hpp"
#include "tests/app/stage.hpp"

using namespace pf;
using namespace pf::app;
using namespace pf::app::staged;

TEST_CASE("every page of every lesson can be opened, done and left, and cuts nothing") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  AppContext& context = stage.context();
  context.session.set_rate(0);
  for (const Lesson& lesson : shipped_lessons()) {
    CAPTURE(lesson.title);
    open_lesson(context, lesson);
    REQUIRE(context.lesson);
    for (std::size_t k = 0; k < lesson.pages.size(); ++k) {
      const LessonPage& page = lesson.pages[k];
      CAPTURE(page.title);
      REQUIRE(context.lesson->page_index() == k);
      REQUIRE(stage.ready());
      if (page.scene) CHECK(context.scene.name == page.scene->name);
      CHECK(context.highlight == page.highlight);
      const bool work = !page.task.empty() || page.slow || !page.until.empty();
      stage.frames(2);
      if (work) {
        // A page that goes on with the last one's run may have come true already.
        if (page.scene || !page.task.empty() || page.slow) CHECK_FALSE(context.lesson->done(context));
        context.lesson->help(context);
        REQUIRE(stage.until([&] {
          return context.lesson->task_done(context) && context.lesson->seen() && context.lesson->taken_apart();
        }));
      }
      if (page.question) {
        CHECK_FALSE(context.lesson->done(context));
        context.lesson->answer_ = (page.question->answer + 1) % page.question->choices.size();
        stage.frames(1);
        CHECK_FALSE(context.lesson->done(context));
        context.lesson->answer_ = page.question->answer;
      }
      stage.until([&] { return context.lesson->done(context); });
      CHECK(context.lesson->done(context));
      for (int settle = 0; settle < 4; ++settle) {  // a list that grew gets its scroll bar, then its width
        stage->act(Action::fit);
        stage.frames(1);
      }
      for (const LessonLine& line : page.lines)
        if (!line.formula) CHECK(context.lesson->filled(line.text).find("…") == std::string::npos);
      for (const ImGuiWindow* window : GImGui->Windows)
        if (window->Active && !window->Hidden) {
          CAPTURE(std::string(window->Name));
          CHECK(window->ScrollMax.x <= 0);
        }
      if (context.slow) stage->act(Action::deselect);
      if (!context.lesson->last()) context.lesson->turn_to(context, k + 1);
    }
    close_lesson(context);
    CHECK_FALSE(context.lesson);
    CHECK(context.highlight.empty());
  }
}

TEST_CASE("a wrong value is not the task, large text is for the lesson only") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  AppContext& context = stage.context();
  const std::vector<Lesson> lessons = shipped_lessons();
  REQUIRE(lessons.size() == 10);
  open_lesson(context, lessons[5]);  // PIC, FLIP and APIC
  REQUIRE(stage.ready());
  context.lesson->turn_to(context, 1);
  REQUIRE(stage.ready());
  stage.frames(3);
  CHECK(memory(context).open_left == 3);  // the panel with the marked control is open
  CHECK_FALSE(context.lesson->task_done(context));
  CHECK(context.change({{"/transfer/type", "apic"}}));
  CHECK_FALSE(context.lesson->task_done(context));
  CHECK(context.change({{"/transfer/type", "flip"}}));
  CHECK_FALSE(context.lesson->task_done(context));  // its ratio is not the one that is asked for
  CHECK(context.change({{"/transfer/flip_ratio", 1}}));
  CHECK(context.lesson->task_done(context));
  CHECK_FALSE(context.lesson->seen());
  const float scale = context.view.ui_scale;
  context.lesson->usual_scale = scale;
  context.lesson->big = true;
  context.view.ui_scale = 1.6F * scale;
  stage.frames(4);
  close_lesson(context);
  CHECK(context.view.ui_scale == scale);
}
