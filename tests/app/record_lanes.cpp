// Pictures of lanes side by side: of each common time that is due, whatever the window is doing meanwhile.
#include <cstdlib>

#include "app/compare/desk.hpp"
#include "core/charts/image.hpp"
#include "tests/app/find_text.hpp"
#include "tests/app/recorded.hpp"

using namespace pf;
using namespace pf::app;
using namespace pf::app::staged;

namespace {

/// Two lanes of ten common times, 5 ms apart.
CompareDesk& started(Stage& stage) {
  REQUIRE(stage.ready());
  CompareDesk& desk = compare_of(stage.context());
  REQUIRE(desk.add(stage.context(), "/time/step", 0.0025));
  const auto begun = [&] {  // a short one may have come to its end between two frames
    return desk.status.state == CompareState::running || desk.status.state == CompareState::finished;
  };
  REQUIRE(stage.until([&] { return desk.frame && begun(); }));
  stage->act(Action::fit);
  stage.frames(4);
  return desk;
}

}  // namespace

TEST_CASE("lanes are recorded side by side, each common time that is due once") {
  NEEDS_DISPLAY();
  Stage stage(short_fall());
  CompareDesk& desk = started(stage);
  AppContext& context = stage.context();
  stage->act(Action::record);
  stage.frames(4);
  REQUIRE(find_text("Record the lanes side by side"));
  REQUIRE(find_text("Files are of one run"));
  RecordChoice& choice = stage->recorder().choice();
  choice.folder = (stage.folder / "frames").string();
  choice.by_steps = true;
  choice.every.steps = 4;
  choice.size = 1;
  click_text(stage, "Record from the start");
  REQUIRE(stage->recorder().of_lanes());
  REQUIRE(stage.until([&] { return !stage->recorder().busy(); }));
  const auto files = files_in(choice.folder);
  REQUIRE(files.size() == 4);  // at 0, 20, 40 ms, and the end
  for (std::size_t k = 0; k < 3; ++k) CHECK(time_of(files[k]) == doctest::Approx(0.02 * static_cast<double>(k)));
  CHECK(time_of(files[3]) == doctest::Approx(0.05));
  const Image first = read_image(files[0]), last = read_image(files[3]);
  CHECK(first.width == 1280);
  CHECK(first.height == 720);
  CHECK(first.pixels != last.pixels);
  CHECK(desk.status.state == CompareState::finished);
  CHECK(context.problems.empty());
  if (const char* keep = std::getenv("PUSHFORWARD_SCREENS")) write_png(last, fs::path(keep) / "recorded-lanes.png");
  // What the record led is what the lanes do alone.
  const auto led = desk.frame;
  desk.comparison.run();
  REQUIRE(stage.until([&] { return desk.frame && desk.frame->run != led->run && desk.frame->at_end; }));
  for (std::size_t k = 0; k < 2; ++k) CHECK(desk.frame->lanes[k].snapshot->x == led->lanes[k].snapshot->x);
}

TEST_CASE("a record of lanes waits for the key, and ends with the comparison") {
  NEEDS_DISPLAY();
  Scene scene = small();
  scene.time.end = 100;
  Stage stage(scene);
  CompareDesk& desk = started(stage);
  RecordChoice& choice = stage->recorder().choice();
  choice.folder = (stage.folder / "frames").string();
  choice.by_steps = true;
  choice.every.steps = 1;
  REQUIRE(stage->recorder().begin(stage.context(), false));
  const long begun = desk.frame->number;
  REQUIRE(stage.until([&] { return stage->recorder().frames() >= 3; }));
  CHECK(begun > 0);
  CHECK(time_of(files_in(choice.folder).front()) >= 0.005 * static_cast<double>(begun) - 1e-12);
  stage->act(Action::run_pause);
  stage.frames(6);
  const long held = stage->recorder().frames();
  stage.frames(10);
  CHECK(stage->recorder().frames() == held);
  stage->act(Action::step);  // it leads them, nobody else
  stage.frames(6);
  CHECK(stage->recorder().frames() == held);
  stage->act(Action::run_pause);
  REQUIRE(stage.until([&] { return stage->recorder().frames() >= held + 2; }));
  desk.close(stage.context());
  REQUIRE(stage.until([&] { return !stage->recorder().busy(); }));
  const auto files = files_in(choice.folder);
  CHECK(static_cast<long>(files.size()) == stage->recorder().frames());
  // No common time was left out, none came twice.
  for (std::size_t k = 1; k < files.size(); ++k)
    CHECK(time_of(files[k]) - time_of(files[k - 1]) == doctest::Approx(0.005));
}
