// What may be said on the command line, and what is said back.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "program.hpp"

using namespace pf::test;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("--version names version, commit and compiler; --help every subcommand that is built") {
  const Workplace here;
  const Outcome version = here.run("--version");
  CHECK(version.status == 0);
  CHECK(contains(version.out, "pushforward 0.1.0 (commit "));
  const Outcome help = here.run("--help");
  CHECK(help.status == 0);
  for (const char* command : {"run", "check", "verify", "study", "compare", "bench", "list", "schema"})
    CHECK(contains(help.out, std::string("\n  ") + command));
  for (const char* command : {"run", "check", "verify", "study", "compare", "bench", "list", "schema"}) {
    CAPTURE(command);
    const Outcome own = here.run(std::string(command) + " --help");
    CHECK(own.status == 0);
    CHECK(contains(own.out, command));
    CHECK(own.err.empty());
  }
}

TEST_CASE("bad usage: exit status 2, nothing on stdout, what was found and what is allowed on stderr") {
  const Workplace here;
  here.put("scene.json", falling_block);
  const struct {
    const char *arguments, *said;
  } cases[] = {
      {"run scene.json --setps 3", "did you mean --steps?"},
      {"run", "SCENE is required"},
      {"veriyf", "did you mean verify?"},
      {"study", "STUDY is required"},
      {"study a.json", "--out is required"},
      {"compare a", "B is required"},
      {"compare a b c", "one argument too many"},
      {"rnu scene.json", "one argument too many"},
      {"chekc", "did you mean check?"},
      {"list colours", "materials"},
      {"run scene.json --threads 0", "--threads"},
      {"run scene.json --threads two", "--threads"},
      {"run scene.json --until -1", "a number of seconds above 0"},
      {"run scene.json --until nan", "a number of seconds above 0"},
      {"run scene.json --steps -3", "--steps"},
      {"run scene.json --export=obj --out o", "--export"},
      {"run scene.json --images=0x10 --out o", "each from 16 to 16384 pixels"},
      {"run scene.json --images=800 --out o", "WIDTHxHEIGHT"},
      {"run scene.json --images", "--out DIR"},
      {"run scene.json --export=csv", "--out DIR"},
      {"run scene.json --checkpoint-every 1", "--out DIR"},
      {"run scene.json --set time/step=1", "time/step"},
      {"run scene.json --set /time/stpe=1", "/time/stpe"},
      {"run scene.json --set /time/step=-1", "/time/step"},
  };
  for (const auto& bad : cases) {
    CAPTURE(bad.arguments);
    const Outcome outcome = here.run(bad.arguments);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CAPTURE(outcome.err);
    CHECK(contains(outcome.err, bad.said));
  }
}

TEST_CASE("files that cannot be read or written: exit status 4, with the file's name") {
  const Workplace here;
  here.put("scene.json", falling_block);
  here.put("plain", "a file, not a folder");
  for (const char* arguments : {"run nowhere.json", "check nowhere.json", "nowhere.json", "run scene.json --out plain",
                                "run scene.json --resume nowhere.pfc"}) {
    CAPTURE(arguments);
    const Outcome outcome = here.run(arguments);
    CHECK(outcome.status == 4);
    CHECK((contains(outcome.err, "nowhere") || contains(outcome.err, "plain")));
  }
  CHECK(contains(here.run("run welcme").err, "did you mean the shipped scene welcome?"));
}

TEST_CASE("check lists every problem of every file, with file and pointer") {
  const Workplace here;
  here.put("good.json", falling_block);
  std::string text = falling_block;
  text.replace(text.find("1000"), 4, "-1");
  text.replace(text.find("\"spacing\": 0.25"), 15, "\"spacing\": 0");
  here.put("bad.json", text);
  const Outcome good = here.run("check good.json");
  CHECK(good.status == 0);
  CHECK(contains(good.out, "good.json: valid"));
  const Outcome bad = here.run("check good.json bad.json");
  CHECK(bad.status == 2);
  CHECK(contains(bad.err, "bad.json: /materials/rubber/density"));
  CHECK(contains(bad.err, "bad.json: /grid/spacing"));
  CHECK_FALSE(contains(bad.err, "good.json"));
}

TEST_CASE("list: one name first on each line; schema: JSON") {
  const Workplace here;
  const Outcome materials = here.run("list materials");
  CHECK(materials.status == 0);
  CHECK(contains("\n" + materials.out, "\nneo_hookean "));
  CHECK(contains("\n" + here.run("list bases").out, "\nquadratic "));
  CHECK(contains("\n" + here.run("list integrators").out, "\nbackward_euler "));
  CHECK(contains("\n" + here.run("list transfers").out, "\nflip "));
  CHECK(contains("\n" + here.run("list solvers").out, "\nauto "));
  CHECK(contains("\n" + here.run("list scenes").out, "\nwelcome "));
  const Outcome schema = here.run("schema");
  CHECK(schema.status == 0);
  CHECK(nlohmann::json::parse(schema.out)["properties"].contains("dimension"));
}

TEST_CASE("without a display, a scene cannot be opened: it says how to run it instead") {
  const Workplace here;
  here.put("scene.json", falling_block);
  const Outcome outcome = here.run("scene.json");
  CHECK(outcome.status == 4);
  CHECK(contains(outcome.err, "No window can be opened"));
  CHECK(contains(outcome.err, "pushforward run scene.json"));
}
