#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "core/params/setting.hpp"

TEST_CASE("docs/parameters.md is what the tables say") {
  const char* const file = PUSHFORWARD_SOURCE "/docs/parameters.md";
  if (std::getenv("PUSHFORWARD_UPDATE_DOCS")) std::ofstream(file) << pf::settings_markdown();
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  CHECK_MESSAGE(text.str() == pf::settings_markdown(), "run it again with PUSHFORWARD_UPDATE_DOCS=1 to write the file");
}
