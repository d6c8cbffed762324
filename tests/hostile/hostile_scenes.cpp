// Malformed, empty, huge, truncated and hostile scenes, through the program itself: exit status 2, a message that
// names pointer, value and what is allowed; never a crash, a hang or gigabytes.
#include <doctest/doctest.h>

#include <string>

#include "../cli/program.hpp"

using namespace pf::test;

namespace {

/// Of the prefix that bounds time and memory (address sanitizers reserve more than any bound).
const char* const bounds =
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    "timeout 60";
#else
    "sh -c 'ulimit -v 4000000; exec timeout 20 \"$@\"' bounded";
#endif

/// falling_block with one part replaced.
std::string block_with(const std::string& old, const std::string& now) {
  std::string text = falling_block;
  const std::size_t at = text.find(old);
  REQUIRE(at != std::string::npos);
  return text.replace(at, old.size(), now);
}

std::string repeat(const std::string& text, int times, const std::string& between = "") {
  std::string all;
  all.reserve((text.size() + between.size()) * static_cast<std::size_t>(times));
  for (int k = 0; k < times; ++k) all += (k ? between : "") + text;
  return all;
}

const std::string box = R"({"type": "box", "min": [0, 0], "max": [0.5, 0.5]})";

/// Both commands that read scenes refuse it, and say so with these words.
void check_refused(const std::string& text, const std::string& said, const std::string& also = "") {
  const Workplace here;
  here.put("hostile.json", text);
  for (const char* const command : {"check hostile.json", "run hostile.json --quiet"}) {
    const Outcome outcome = here.run(command, bounds);
    CAPTURE(command);
    CAPTURE(text.substr(0, 300));
    CAPTURE(outcome.err.substr(0, 600));
    CHECK(outcome.status == 2);
    CHECK(outcome.out.find("nan") == std::string::npos);
    CHECK(outcome.err.find(said) != std::string::npos);
    CHECK(outcome.err.find(also) != std::string::npos);
    CHECK(outcome.err.find("found") != std::string::npos);
    CHECK(outcome.err.size() < 30'000);
  }
}

}  // namespace

TEST_CASE("empty, truncated and malformed files") {
  check_refused("", "found nothing");
  check_refused("// nothing but a comment", "found nothing");
  check_refused(std::string(falling_block).substr(0, 200), "the end of the text", "line ");
  check_refused(std::string("\xEF\xBB\xBF") + falling_block, "byte order mark");
  check_refused(std::string("\xFF\xFE{\0", 4), "UTF-16");
  check_refused(block_with("Block", "Bl\xFFock"), "/name", "UTF-8");
  check_refused(std::string(3000, '\0'), "the document");
  check_refused(
      "\x7F"
      "ELF\x02\x01\x01",
      "the document");
  check_refused("[]", "an object");
  check_refused("{}", "/dimension", "required");
}

TEST_CASE("a hundred thousand brackets, and other depths") {
  check_refused(repeat("[", 100'000), "brackets");
  check_refused(repeat("{\"a\":", 100'000), "brackets");
  check_refused(repeat("[", 100'000) + repeat("]", 100'000), "brackets");
  check_refused(block_with("\"Block\"", repeat("[", 100'000)), "/name");
  const std::string deep = repeat(R"({"type": "union", "of": [)", 40) + box + repeat("]}", 40);
  check_refused(block_with(box, deep), "/bodies/0/shape/of/0", "16 deep");
  const std::string wide = R"({"type": "union", "of": [)" + repeat(box, 900, ",") + "]}";
  check_refused(block_with(box, R"({"type": "union", "of": [)" + wide + "," + wide + "]}"), "/bodies/0/shape", "1000");
  check_refused(block_with("[0, -10]", "[0, \"" + repeat("(", 50'000) + "1" + repeat(")", 50'000) + "\"]"),
                "/gravity/1");
  check_refused(block_with("[0, -10]", "[0, \"" + repeat("-", 30'000) + "1\"]"), "/gravity/1");
  check_refused(block_with("[0, -10]", "[0, \"" + repeat("1+", 100'000) + "1\"]"), "/gravity/1");
}

TEST_CASE("numbers that are none, too large or out of range") {
  check_refused(block_with("[0, -10]", "[0, NaN]"), "/gravity/1", "NaN");
  check_refused(block_with("[0, -10]", "[0, Infinity]"), "/gravity/1", "Infinity");
  check_refused(block_with("[0, -10]", "[0, 1e309]"), "/gravity/1", "1e309");
  check_refused(block_with("[0, -10]", "[0, 1e308]"), "/gravity/1", "1e308");
  check_refused(block_with("[0, -10]", "[0, \"0/0\"]"), "/gravity/1", "NaN");
  check_refused(block_with("1e5", "1e308"), "/materials/rubber/young", "1e308");
  check_refused(block_with("1000", "-1000"), "/materials/rubber/density", "> 0");
  check_refused(block_with("0.3}", "0.5}"), "/materials/rubber/poisson", "< 0.5");
  check_refused(block_with("0.3}", "-1}"), "/materials/rubber/poisson", "> -1");
  check_refused(block_with("\"spacing\": 0.25", "\"spacing\": 0"), "/grid/spacing", "> 0");
  check_refused(block_with("\"step\": 0.01", "\"step\": 0"), "/time/step", "> 0");
  check_refused(block_with("\"step\": 0.01", "\"step\": 1e-300"), "/time/step", "1e9");
  check_refused(block_with("\"dimension\": 2", "\"dimension\": 4"), "/dimension", "2 (plane strain) or 3");
}

TEST_CASE("duplicate and unknown keys") {
  check_refused(block_with("\"dimension\": 2", "\"dimension\": 2, \"dimension\": 3"), "/dimension", "second time");
  check_refused(block_with("\"young\"", "\"yuong\""), "/materials/rubber/yuong", "\"young\"");
  check_refused(block_with("\"young\"", "\"__proto__\": 1, \"young\""), "/materials/rubber/__proto__");
}

TEST_CASE("too many of anything") {
  const std::string body = R"({"material": "rubber", "shape": )" + box + "}";
  const std::string bodies = "\"bodies\": [" + repeat(body, 20'000, ",");
  check_refused(block_with("\"bodies\": [", bodies + ","), "/bodies", "at most 10000");
  check_refused(block_with("\"bodies\": [", "\"bodies\": [" + repeat(body, 1'000'000, ",") + ","), "the document",
                "bytes");
  check_refused(block_with("\"Block\"", '"' + std::string(2'000'000, 'x') + '"'), "/name", "bytes");
  check_refused(block_with("\"name\": \"Block\"", "\"name\": " + repeat("[0,", 1) + repeat("0", 1'500'000, ",") + "]"),
                "/name", "values");
}

TEST_CASE("scenes that would need more than the machine has are refused with the estimate before they are built") {
  for (
      const char* const shape :
      {R"({"type": "ball", "center": [0, 0], "radius": 1e9})",
       R"({"type": "where", "expression": "X", "min": [-1e9, -1e9], "max": [1e9, 1e9]})",
       R"({"type": "box", "min": [0, 0], "max": [1, 1], "scale": 1e6})",
       R"({"type": "intersection", "of": [{"type": "ball", "center": [0, 0], "radius": 1e9}, {"type": "box", "min": [-1e9, -1e9], "max": [1e9, 1e9]}]})"})
    check_refused(block_with(box, shape), "GB");
  check_refused(block_with("\"spacing\": 0.25", "\"spacing\": 1e-7"), "GB");
}

TEST_CASE("shapes that hold nothing") {
  const char* const two =
      R"([{"type": "box", "min": [0, 0], "max": [1, 1]}, {"type": "box", "min": [2, 2], "max": [3, 3]}])";
  check_refused(block_with(box, std::string(R"({"type": "intersection", "of": )") + two + "}"), "/bodies/0/shape");
  check_refused(block_with(box, R"j({"type": "where", "expression": "sqrt(-1 - X^2)", "min": [0, 0], "max": [1, 1]})j"),
                "/bodies/0/shape");
  check_refused(block_with(box, R"({"type": "polygon", "points": [[0, 0], [1, 1], [1, 0], [0, 2]]})"),
                "/bodies/0/shape/points");
  check_refused(block_with(box, R"({"type": "half_space", "point": [0, 0], "normal": [0, 1]})"), "/bodies/0/shape",
                "bounds");
}

TEST_CASE("what goes wrong only while it runs ends with exit status 3 and what it was") {
  for (const char* const force : {R"j(["sqrt(-1 - x^2)", 0])j", R"j(["1e300*(x + 1)", 0])j"}) {
    const Workplace here;
    here.put("hostile.json", block_with("\"name\"", "\"body_force\": " + std::string(force) + ", \"name\""));
    const Outcome outcome = here.run("run hostile.json", bounds);
    CAPTURE(outcome.err.substr(0, 1000));
    CHECK(outcome.status == 3);
    CHECK(outcome.err.find("Step 1") != std::string::npos);
  }
}

TEST_CASE("streams without end and things that are no files") {
  const Workplace here;
  CHECK(here.run("check /dev/zero", bounds).status == 2);
  CHECK(here.run("check .", bounds).status == 4);
  CHECK(here.run("check none.json", bounds).status == 4);
  CHECK(here.run("check /dev/null", bounds).status == 2);
}
