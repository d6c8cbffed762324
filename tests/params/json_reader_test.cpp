#include "core/params/json_reader.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <limits>

#include "core/params/json_text.hpp"
#include "core/params/nearest.hpp"
#include "core/params/pointer.hpp"

using namespace pf;

namespace {

Json read(std::string_view text) {
  std::vector<Problem> problems;
  Json value = read_json(text, problems);
  REQUIRE(problems.empty());
  return value;
}

/// The problem of a text that is no JSON.
Problem problem_of(std::string_view text, const JsonLimits& limits = {}) {
  std::vector<Problem> problems;
  try {
    read_json(text, problems, limits);
  } catch (const InputError& error) {
    REQUIRE(error.problems().size() == 1);
    return error.problems()[0];
  }
  FAIL("accepted: " << text.substr(0, 60));
  return {};
}

}  // namespace

TEST_CASE("JSON with comments gives the values that it says") {
  const Json value = read(
      "// a scene\n{ \"a\": [1, -2.5e1, true], // half\n  \"b\": { \"c\": \"\\u00e9\\ud83d\\ude00/\\n\" }, \"d\": null "
      "}\n// end");
  CHECK(value["a"] == Json::array({1, -25.0, true}));
  CHECK(value["b"]["c"] == "\xC3\xA9\xF0\x9F\x98\x80/\n");
  CHECK(value["d"].is_null());
  CHECK(read("18446744073709551615").get<std::uint64_t>() == std::numeric_limits<std::uint64_t>::max());
  CHECK(read("-9223372036854775808").get<std::int64_t>() == std::numeric_limits<std::int64_t>::min());
  CHECK(read("36893488147419103232").get<double>() == 36893488147419103232.0);
  CHECK(read("\"https://x\"") == "https://x");
}

TEST_CASE("numbers too small for double are 0; too large ones are problems and not infinity") {
  CHECK(read("1e-400").get<double>() == 0);
  CHECK(read("0." + std::string(400, '0') + "1").get<double>() == 0);
  CHECK(read(std::string(400, '1') + "e-390").get<double>() == doctest::Approx(1.1111111e9));
  for (const std::string& text :
       {std::string("1e309"), "-" + std::string(400, '9'), std::string("1e99999999999999999999")}) {
    std::vector<Problem> problems;
    const Json value = read_json("{\"a\":[0,\n" + text + "]}", problems);
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].pointer == "/a/1");
    CHECK(problems[0].line == 2);
    CHECK(problems[0].allowed.find("double precision") != std::string::npos);
  }
}

TEST_CASE("duplicate keys are all found, with their places, and the first counts") {
  std::vector<Problem> problems;
  const Json value = read_json("{\"a\": {\"x\": 1,\n\"x\": 2},\n \"b\": 3,\n \"b\": {\"c\": 1, \"c\": 1}}", problems);
  REQUIRE(problems.size() == 3);
  CHECK(problems[0].pointer == "/a/x");
  CHECK(problems[0].line == 2);
  CHECK(problems[1].pointer == "/b");
  CHECK(problems[1].line == 4);
  CHECK(problems[2].pointer == "/b/c");
  CHECK(value["a"]["x"] == 1);
}

TEST_CASE("what is no JSON is refused at its place") {
  const std::pair<const char*, const char*> cases[] = {
      {"", "nothing"},
      {"  // only a comment", "nothing"},
      {"{\"a\": 1", "the end"},
      {"{\"a\" 1}", "\"1}\""},
      {"{\"a\": }", "\"}\""},
      {"{\"a\": 1,}", "\"}\""},
      {"[1, 2,]", "\"]\""},
      {"{a: 1}", "\"a: 1}\""},
      {"{'a': 1}", "\"'a': 1}\""},
      {"[01]", "leading 0"},
      {"[1.]", "\"]\""},
      {"[.5]", "\".5]\""},
      {"[+1]", "\"+1]\""},
      {"[1e]", "\"]\""},
      {"[-]", "\"-]\""},
      {"[NaN]", "NaN"},
      {"[nan]", "nan"},
      {"[Infinity]", "Infinity"},
      {"[-Infinity]", "-Infinity"},
      {"[0x10]", "x10"},
      {"[tru]", "tru"},
      {"\"abc", "no end"},
      {"\"a\nb\"", "line break"},
      {"\"\\q\"", "\\q"},
      {"\"\\ud800\"", "no character"},
      {"\"\\ud800\\u0041\"", "surrogate"},
      {"\"\\u00g0\"", "u00g0"},
      {"\"\\u0000\"", "no character"},
      {"{} {}", "after the end"},
      {"/* c */ {}", "/* c"},
      {"\xEF\xBB\xBF{}", "byte order mark"},
      {"\xFF\xFE{", "UTF-16"},
      {"\"\xC3\x28\"", "not UTF-8"},
      {"\"\xC0\xAF\"", "not UTF-8"},
      {"\"\xED\xA0\x80\"", "not UTF-8"},
      {"\"\xF4\x90\x80\x80\"", "not UTF-8"},
      {"\"\xE2\x82", "not UTF-8"},
  };
  for (const auto& [text, found] : cases) {
    CAPTURE(text);
    const Problem problem = problem_of(text);
    CHECK_MESSAGE(problem.found.find(found) != std::string::npos, problem.found);
    CHECK(!problem.allowed.empty());
    CHECK(problem.line >= 1);
  }
  CHECK(problem_of("{\"a\": [1,\n {\"b\":\n ?}]}").pointer == "/a/1/b");
  CHECK(problem_of("{\"a\": [1,\n {\"b\":\n ?}]}").line == 3);
}

TEST_CASE("hostile sizes are refused at once") {
  const auto begin = std::chrono::steady_clock::now();
  CHECK(problem_of(std::string(100'000, '[')).found.find("deep") != std::string::npos);
  std::string objects;
  for (int k = 0; k < 100'000; ++k) objects += "{\"a\":";
  CHECK(problem_of(objects).found.find("deep") != std::string::npos);
  CHECK(problem_of("[" + std::string(3'000'000, ' ') + "]", {1'000'000, 10, 10}).found.find("bytes") !=
        std::string::npos);
  std::string many = "[0";
  for (int k = 0; k < 2'000'000; ++k) many += ",0";
  CHECK(problem_of(many + "]").found.find("values") != std::string::npos);
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(5));
}

TEST_CASE("an object with many keys costs no quadratic time") {
  std::string text = "{";
  for (int k = 0; k < 200'000; ++k) text += "\"k" + std::to_string(k) + "\":0,";
  text += "\"k7\":0}";
  std::vector<Problem> problems;
  const auto begin = std::chrono::steady_clock::now();
  const Json value = read_json(text, problems);
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(5));
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].pointer == "/k7");
  CHECK(value.size() == 200'000);
}

TEST_CASE("lines are found for values, and for missing ones those of what should hold them") {
  const std::string text = "{\n \"a\": [1,\n 2],\n \"b/c\": { \"d\":\n 1 } }";
  const std::vector<std::string> pointers = {"", "/a", "/a/1", "/b~1c/d", "/b~1c/e/f", "/z"};
  CHECK(json_lines(text, pointers) == std::vector<int>{1, 2, 3, 5, 4, 1});
}

TEST_CASE("numbers are written short and read back equal") {
  const std::pair<double, const char*> cases[] = {{0, "0"},
                                                  {1, "1"},
                                                  {-2.5, "-2.5"},
                                                  {0.1, "0.1"},
                                                  {1000, "1000"},
                                                  {1e5, "100000"},
                                                  {1e6, "1000000"},
                                                  {12e6, "1.2e7"},
                                                  {1e-6, "1e-6"},
                                                  {2.5e9, "2.5e9"},
                                                  {1.0 / 3, "0.3333333333333333"},
                                                  {5e-324, "5e-324"}};
  for (const auto& [value, text] : cases) {
    CHECK(number_text(value) == text);
    CHECK(read(text).get<double>() == value);
  }
}

TEST_CASE("pointers are split as RFC 6901 says") {
  CHECK(split_pointer("")->empty());
  CHECK(*split_pointer("/a~1b/~0/") == std::vector<std::string>{"a/b", "~", ""});
  CHECK(!split_pointer("a"));
  CHECK(!split_pointer("/~2"));
  CHECK(!split_pointer("/~"));
  CHECK(pointer_step("a/b~") == "/a~1b~0");
  CHECK(array_index("0") == 0u);
  CHECK(array_index("12") == 12u);
  for (const char* const bad : {"", "-1", "01", "1a", "-", "99999999999999999999999"}) CHECK(!array_index(bad));
  CHECK(is_at_or_below("/a/b", "/a"));
  CHECK(!is_at_or_below("/ab", "/a"));
}

TEST_CASE("the nearest name is suggested, and none where none is near") {
  const std::vector<std::string> known = {"young", "poisson", "density", "model"};
  CHECK(nearest_name("yuong", known) == "young");
  CHECK(nearest_name("Young", known) == "young");
  CHECK(nearest_name("poison", known) == "poisson");
  CHECK(nearest_name("temperature", known).empty());
  CHECK(nearest_name("", known).empty());
}
