// Runs the built program as a user would.
#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "core/files.hpp"
#include "tests/temporary_folder.hpp"

namespace pf::test {

struct Outcome {
  int status = -1;  ///< exit status; 128 + signal where one ended it
  std::string out, err;
};

/// A folder for one test, gone afterwards.
class Workplace : public TemporaryFolder {
 public:
  /// Writes a file here.
  void put(const std::string& name, const std::string& text) const { write_atomically(path() / name, text); }

  /// `pushforward ARGUMENTS` in this folder; `arguments` go through the shell. `prefix` comes before the program.
  Outcome run(const std::string& arguments, const std::string& prefix = "") const {
    const std::string out = (path() / "stdout.txt").string(), err = (path() / "stderr.txt").string();
    const std::string command = "cd '" + path().string() + "' && env -u DISPLAY -u WAYLAND_DISPLAY " + prefix + " '" +
                                PUSHFORWARD_BINARY + "' " + arguments + " >'" + out + "' 2>'" + err + "' </dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_file(out), read_file(err)};
  }
};

/// A block of 2D material that falls for 0.05 s in 5 steps; 16 particles.
inline const char* const falling_block = R"({
  // comments are allowed
  "name": "Block", "dimension": 2, "gravity": [0, -10],
  "grid": {"spacing": 0.25}, "time": {"end": 0.05, "step": 0.01, "frame": 0.02},
  "materials": {"rubber": {"model": "neo_hookean", "density": 1000, "young": 1e5, "poisson": 0.3}},
  "bodies": [{"name": "block", "material": "rubber", "shape": {"type": "box", "min": [0, 0], "max": [0.5, 0.5]}}]
})";

}  // namespace pf::test
