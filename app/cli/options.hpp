// What the command line may say: every option of every subcommand, and where its value goes.
#pragma once

#include <string>
#include <vector>

#include "app/cli/commands.hpp"

namespace CLI {
class App;
}

namespace pf::app {

inline constexpr const char* about =
    "Pushforward: an interactive workbench for the implicit material point method.\n"
    "Without a subcommand, opens the app on SCENE, or on the welcome scene.";

struct Parsed {
  std::string scene;
  std::vector<std::string> sets, files;
  std::string kind;
  RunOptions run;
  BenchOptions bench;
  CompareOptions compare;
  ChartOptions chart;
  StudyRunOptions study;
  VerifyOptions verify;
  AdviseOptions advise;
  std::string images, chart_size;
  bool version = false, reset_settings = false;
};

/// Declares them all.
void declare_options(CLI::App& app, Parsed& parsed);
/// "1280x800"; throws CLI::ValidationError.
PictureSize parse_size(const std::string& text, const char* option);

}  // namespace pf::app
