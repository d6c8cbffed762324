#include <string>
#include <vector>

#include "app/cli/commands.hpp"
#include "app/cpu_guard.hpp"

// Read by cpu_guard.cpp before anything else runs.
extern "C" const unsigned pushforward_needs;
extern "C" const unsigned pushforward_needs = pf::app::compiled_features();

int main(int argc, char** argv) {
  return pf::app::run_command_line(std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc));
}
