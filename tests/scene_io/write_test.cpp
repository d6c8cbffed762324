#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "scene_text.hpp"
#include "tests/temporary_folder.hpp"

using namespace pf;

TEST_CASE("a saved scene loads equal, leaves no other file and replaces what was there") {
  const test::TemporaryFolder folder;
  const Scene scene = parse_scene(full_scene().dump(), "test");
  std::ofstream(folder / "a.json") << "old";
  save_scene(scene, folder / "a.json");
  CHECK(load_scene(folder / "a.json") == scene);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) files += entry.exists();
  CHECK(files == 1);
  CHECK_THROWS_AS(save_scene(scene, folder / "none" / "a.json"), FileError);
  std::filesystem::create_directory(folder / "taken");
  CHECK_THROWS_AS(save_scene(scene, folder / "taken"), FileError);
}

TEST_CASE("what cannot be read as a file is a FileError, what is too large an InputError") {
  const test::TemporaryFolder folder;
  CHECK_THROWS_AS(load_scene(folder / "none.json"), FileError);
  CHECK_THROWS_AS(load_scene(folder.path()), FileError);
  CHECK_THROWS_AS(load_scene("/dev/zero"), InputError);
  std::ofstream(folder / "empty.json");
  CHECK_THROWS_AS(load_scene(folder / "empty.json"), InputError);
}

TEST_CASE("scenes are written for people: short objects on a line, defaults left out") {
  const std::string text = scene_text(parse_scene(small_scene().dump(), "test"));
  CHECK(text == R"({
  "format": "pushforward/scene",
  "version": 1,
  "dimension": 2,
  "grid": { "spacing": 0.1 },
  "materials": { "rubber": { "model": "neo_hookean", "density": 1000, "young": 100000, "poisson": 0.3 } },
  "bodies": [
    { "name": "body1", "material": "rubber", "shape": { "type": "box", "min": [0, 0], "max": [1, 1] } }
  ]
}
)");
  for (std::size_t begin = 0, end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
    CHECK(end - begin <= 112);
}

TEST_CASE("any text in a name survives; the hash follows the scene and not its layout") {
  Scene scene = parse_scene(small_scene().dump(), "test");
  const std::string before = scene_hash(scene);
  CHECK(before.size() == 16);
  CHECK(scene_hash(parse_scene("// a comment\n" + small_scene().dump(4), "test")) == before);
  scene.name = "Caf\xC3\xA9 \"1\" \\ /\n\t\x7F \xF0\x9F\x98\x80";
  scene.materials[0].name = scene.bodies[0].material = "a/b~c \"d\"";
  CHECK(parse_scene(scene_text(scene), "text") == scene);
  CHECK(scene_hash(scene) != before);
}

TEST_CASE("numbers survive to the last bit") {
  Scene scene = parse_scene(small_scene().dump(), "test");
  for (const double value : {0.1, 1.0 / 3, 1e-300, 123456789.123456789, 5e-324, 1e5 + 1e-9}) {
    scene.time.step = 0.01;
    scene.gravity.x() = value;
    CHECK(parse_scene(scene_text(scene), "text").gravity.x() == value);
  }
  scene.bodies[0].seed = 18446744073709549568u - 2048;
  CHECK(parse_scene(scene_text(scene), "text") == scene);
  scene.bodies[0].seed = 9007199254740993;  // 2^53 + 1
  CHECK(parse_scene(scene_text(scene), "text") == scene);
}
