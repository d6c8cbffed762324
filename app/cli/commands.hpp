// The subcommands. Each returns an exit status; InputError and FileError are reported by run_command_line.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.hpp"
#include "core/studies/table_chart.hpp"

namespace pf::app {

/// INTERFACE, "Exit status".
enum ExitStatus : int {
  exit_done = 0,
  exit_comparison_failed = 1,
  exit_bad_input = 2,
  exit_simulation_failed = 3,
  exit_file_error = 4,
  exit_interrupted = 130,
};

struct PictureSize {
  int width = 1280, height = 800;  ///< [pixels]
};

struct RunOptions {
  std::string scene;              ///< file, or name of a shipped scene
  std::vector<std::string> sets;  ///< --set, in order
  std::optional<double> until;    ///< [s]
  std::optional<long> steps;
  std::optional<int> threads;
  std::optional<std::filesystem::path> out;
  bool quiet = false;
  std::optional<PictureSize> images;
  std::optional<std::filesystem::path> video;
  bool energy = false;  ///< energy.csv: the account of the energy by cause
  bool plain = false;   ///< pictures without title, colour bar, axes and scale
  std::optional<std::string> export_format;
  std::optional<double> checkpoint_every;  ///< [s] of simulated time
  std::optional<std::filesystem::path> resume;
};

struct BenchOptions {
  std::optional<std::filesystem::path> json;
  std::optional<int> threads;            ///< 1 when not given
  std::optional<std::size_t> particles;  ///< in each case, about
  std::optional<int> dimension;          ///< only this one
  std::optional<std::string> basis;      ///< only this one
  bool quick = false;                    ///< small and short
};

struct CompareOptions {
  std::filesystem::path a, b;
  double tolerance = 0;  ///< of the largest relative difference
};

struct ChartOptions {
  TableChart chart;
  std::filesystem::path out;   ///< .svg, .png or .csv
  PictureSize size{820, 500};  ///< a PNG has twice as many pixels
  bool dark = false;
};

struct StudyRunOptions {
  std::vector<std::string> studies;  ///< files, or names of shipped studies
  std::filesystem::path out;         ///< with several studies, each gets a folder of its name in it
  int jobs = 1;
  bool fresh = false, quiet = false;
};

struct VerifyOptions {
  std::vector<std::string>
      cases;  ///< shipped cases, "quick" for the short ones of them, or files; none: all shipped ones
  bool list = false;
  std::optional<std::filesystem::path> json;
  std::filesystem::path out;  ///< a folder of results and charts a case; "" keeps none
};

struct AdviseOptions {
  std::string scene;              ///< file, or name of a shipped scene
  std::vector<std::string> sets;  ///< --set, in order
  std::optional<double> at;       ///< [s]
  std::optional<int> threads;
  std::optional<std::filesystem::path> json;
};

/// The whole command line, without the program's name. Never throws.
int run_command_line(const std::vector<std::string>& arguments);

int run_scene(const RunOptions& options);
int check_scenes(const std::vector<std::string>& files);
int run_studies(const StudyRunOptions& options);
int verify(const VerifyOptions& options);
int advise_on(const AdviseOptions& options);
int compare_folders(const CompareOptions& options);
int chart_tables(const ChartOptions& options);
int list_names(const std::string& kind);
int print_schema();
int run_bench(const BenchOptions& options);
/// `scene` empty: the welcome scene, without a window where none can be opened.
int open_app(const std::string& scene, const std::vector<std::string>& sets);

/// What `list` takes.
std::vector<std::string> list_kinds();
/// `name` where such a file exists, else the shipped scene of that name. Throws FileError, the nearest name suggested.
std::filesystem::path find_scene(const std::string& name);
/// The shipped scenes' names, sorted.
std::vector<std::string> shipped_scenes();
/// --set arguments as edits. Throws InputError.
std::vector<Edit> parse_sets(const std::vector<std::string>& sets);
/// "0.1.0 (commit 0123456789ab, GNU 12.2.0)".
std::string version_text();

}  // namespace pf::app
