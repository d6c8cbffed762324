// Pictures, films and files of the run that the window shows.
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "app/record/film.hpp"
#include "app/record/order.hpp"
#include "core/output/export.hpp"
#include "core/simulation.hpp"
#include "tests/app/find_text.hpp"
#include "tests/app/recorded.hpp"

using namespace pf;
using namespace pf::app;
using namespace pf::app::staged;

namespace {

/// From the start to the end, as chosen.
void record(Stage& stage) {
  stage.context().session.set_rate(0);
  REQUIRE(stage->recorder().begin(stage.context(), true));
  REQUIRE(stage.until([&] { return !stage->recorder().busy(); }));
}

bool in_sight(const std::string& words) {
  return find_text(words).has_value();
}

/// A variable of the environment for as long as this lives.
struct Environment {
  Environment(const char* name, const char* value) : name_(name), before_(std::getenv(name)) { setenv(name, value, 1); }
  ~Environment() { setenv(name_, before_.c_str(), 1); }
  const char* name_;
  std::string before_;
};

}  // namespace

TEST_CASE("frames are due by steps, or at the first step at or after each multiple of the interval") {
  FrameClock by_steps({3, 0}, 10, 0.1);
  for (const long step : {10L, 13L, 16L}) {
    CHECK(by_steps.due(step, 0.01 * static_cast<double>(step), 0.01));
    CHECK_FALSE(by_steps.due(step, 0.01 * static_cast<double>(step), 0.01));  // once
    CHECK_FALSE(by_steps.due(step + 1, 0, 0.01));
  }
  CHECK_FALSE(by_steps.due(13, 0.13, 0.01));  // gone back to
  FrameClock by_time({1, 0.025}, 0, 0);
  std::vector<long> due;
  for (long step = 0; step <= 20; ++step)
    if (by_time.due(step, 0.01 * static_cast<double>(step), 0.01)) due.push_back(step);
  CHECK(due == std::vector<long>{0, 3, 5, 8, 10, 13, 15, 18, 20});
  FrameClock fine({1, 0.001}, 0, 0);  // finer than the steps: each once
  for (long step = 0; step < 5; ++step) CHECK(fine.due(step, 0.01 * static_cast<double>(step), 0.01));
}

TEST_CASE("pictures of a run are of the states that were asked for, and the run stays what it is") {
  NEEDS_DISPLAY();
  Stage stage(short_fall());
  REQUIRE(stage.ready());
  RecordChoice& choice = stage->recorder().choice();
  choice.folder = (stage.folder / "frames").string();
  choice.every.seconds = 0.02;
  choice.size = 1;
  record(stage);
  const auto files = files_in(choice.folder);
  REQUIRE(files.size() == 4);  // at 0, 0.02, 0.04, and the end
  CHECK(files[0].filename() == "000000.png");
  for (std::size_t k = 0; k < 3; ++k) CHECK(time_of(files[k]) == doctest::Approx(0.02 * static_cast<double>(k)));
  CHECK(time_of(files[3]) == doctest::Approx(0.05));
  CHECK(read_image(files[0]).width == 1280);
  CHECK(read_image(files[0]).height == 720);
  CHECK(read_image(files[0]).pixels != read_image(files[3]).pixels);
  CHECK(stage.context().problems.empty());
  const auto alone = make_simulation(short_fall(), {1, ""});
  while (alone->step().status == StepStatus::accepted) {
  }
  Snapshot end;
  alone->capture({}, end);
  CHECK(stage.context().snapshot->x == end.x);
  CHECK(stage.context().snapshot->F == end.F);
}

TEST_CASE("without a background only material and walls are opaque, in 2D and 3D") {
  NEEDS_DISPLAY();
  Stage stage(short_fall());
  REQUIRE(stage.ready());
  for (const char* name : {"", "twisted-bar"}) {
    CAPTURE(name);
    if (*name) stage->open_scene(shipped(name), {}, false);
    REQUIRE(stage.ready());
    stage->act(Action::fit);
    stage.frames(4);
    stage->act(Action::picture_bare);
    stage.frames(4);
    const auto files = files_in(stage.folder / "pictures");
    REQUIRE(files.size() == 1);
    const Image image = read_image(files[0]);
    fs::remove(files[0]);
    REQUIRE(image.width >= 800);
    std::size_t clear = 0, opaque = 0;
    for (std::size_t k = 3; k < image.pixels.size(); k += 4) {
      clear += image.pixels[k] == 0;
      opaque += image.pixels[k] == 255;
    }
    CHECK(clear > image.pixels.size() / 4 / 10);
    CHECK(opaque > image.pixels.size() / 4 / 50);
    CHECK(image.at(2, 2)[3] == 0);
    if (const char* keep = std::getenv("PUSHFORWARD_SCREENS"))
      write_png(image, fs::path(keep) / (std::string("bare") + name + ".png"));
  }
}

TEST_CASE("the window is recorded whole, without the mark that it is; Stop ends it") {
  NEEDS_DISPLAY();
  Scene scene = small();
  scene.time.end = 100;
  Stage stage(scene);
  REQUIRE(stage.ready());
  AppContext& context = stage.context();
  context.session.set_rate(0);
  stage->act(Action::record);
  stage.frames(4);
  REQUIRE(in_sight("Record this run"));
  click_text(stage, "The whole window");
  RecordChoice& choice = stage->recorder().choice();
  CHECK(choice.show == RecordChoice::Show::window);
  choice.folder = (stage.folder / "frames").string();
  choice.by_steps = true;
  choice.every.steps = 4;
  click_text(stage, "Record from the start");
  REQUIRE(stage->recorder().on());
  REQUIRE(stage.until([&] { return stage->recorder().frames() >= 6; }));
  REQUIRE(in_sight("Recording:"));
  const auto stop = find_text("Stop");
  click_text(stage, "Stop");
  REQUIRE(stage.until([&] { return !stage->recorder().busy(); }));
  stage.frames(3);
  CHECK_FALSE(in_sight("Recording:"));
  CHECK(context.status.state == RunState::running);  // it goes on
  const auto files = files_in(choice.folder);
  REQUIRE(files.size() >= 6);
  for (std::size_t k = 0; k < files.size(); ++k)
    CHECK(time_of(files[k]) == doctest::Approx(4 * 0.005 * static_cast<double>(k)));
  // Where the mark's button was, the pictures have what is behind it.
  stage->act(Action::run_pause);
  const Image frame = read_image(files[2]), bare = stage->screenshot();
  REQUIRE(frame.width == bare.width);
  const int x = static_cast<int>(stop->x) - 20, y = static_cast<int>(stop->y);
  for (int k = 0; k < 40; ++k)
    for (int a = 0; a < 3; ++a) CHECK(std::abs(frame.at(x + k, y)[a] - bare.at(x + k, y)[a]) < 6);
}

TEST_CASE("files for ParaView come from the same menu") {
  NEEDS_DISPLAY();
  Stage stage(short_fall());
  REQUIRE(stage.ready());
  RecordChoice& choice = stage->recorder().choice();
  choice.what = RecordChoice::What::files;
  choice.folder = (stage.folder / "paraview").string();
  choice.by_steps = true;
  choice.every.steps = 5;
  record(stage);
  for (const char* name : {"particles.pvd", "particles_000000.vtp", "particles_000002.vtp", "grid_000001.vtu"})
    CHECK(fs::exists(fs::path(choice.folder) / name));
  CHECK_FALSE(fs::exists(fs::path(choice.folder) / "particles_000003.vtp"));
  CHECK(stage->recorder().frames() == 3);
}

TEST_CASE("a film is written where ffmpeg is, and the word is clear where it is not") {
  NEEDS_DISPLAY();
  Stage stage(short_fall());
  REQUIRE(stage.ready());
  RecordChoice& choice = stage->recorder().choice();
  choice.what = RecordChoice::What::film;
  choice.file = (stage.folder / "fall").string();
  choice.by_steps = true;
  if (ffmpeg_present()) {
    record(stage);
    std::ifstream in(stage.folder / "fall.mp4", std::ios::binary);
    std::string head(12, 0);
    in.read(head.data(), 12);
    CHECK(head.substr(4, 4) == "ftyp");
    CHECK(stage->recorder().frames() == 11);
  }
  const Environment none("PATH", stage.folder.c_str());
  CHECK_FALSE(ffmpeg_present());
  stage->act(Action::record);
  stage.frames(4);
  CHECK(in_sight("not on this machine"));
  CHECK(choice.what == RecordChoice::What::images);  // what can be had instead
  choice.what = RecordChoice::What::film;
  CHECK_FALSE(stage->recorder().begin(stage.context(), true));
  CHECK_FALSE(stage->recorder().on());
}

TEST_CASE("a disc that takes no more ends the record with its reason, not the run") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  AppContext& context = stage.context();
  context.session.set_rate(0);
  RecordChoice& choice = stage->recorder().choice();
  choice.by_steps = true;
  std::ofstream(stage.folder / "file") << "no folder";
  choice.folder = (stage.folder / "file" / "frames").string();
  CHECK_FALSE(stage->recorder().begin(context, true));

  choice.folder = (stage.folder / "frames").string();
  REQUIRE(stage->recorder().begin(context, true));
  REQUIRE(stage.until([&] { return stage->recorder().frames() >= 3; }));
  fs::remove_all(choice.folder);
  std::ofstream(choice.folder) << "in the way";
  REQUIRE(stage.until([&] { return !stage->recorder().busy(); }));
  stage.frames(3);
  REQUIRE(context.problems.size() == 1);
  CHECK(context.problems[0].found.find("The record ended after") == 0);
  CHECK(context.problems[0].found.find("frames") != std::string::npos);
  const long step = context.status.step;
  REQUIRE(stage.until([&] { return context.status.step > step + 3 || context.status.state == RunState::finished; }));

  if (!ffmpeg_present() || !fs::exists("/dev/full")) return;
  fs::create_symlink("/dev/full", stage.folder / "full.mp4");
  choice.what = RecordChoice::What::film;
  choice.file = (stage.folder / "full.mp4").string();
  context.problems.clear();
  REQUIRE(stage->recorder().begin(context, true));
  REQUIRE(stage.until([&] { return !stage->recorder().busy(); }));
  REQUIRE(context.problems.size() == 1);
  INFO(context.problems[0].found);
  CHECK(context.problems[0].found.find("No space left") != std::string::npos);
}
