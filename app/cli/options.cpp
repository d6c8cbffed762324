#include "app/cli/options.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>

#include "core/bases/basis.hpp"
#include "core/output/export.hpp"
#include "core/params/nearest.hpp"

namespace pf::app {

namespace {

constexpr const char* exit_statuses =
    "Exit status: 0 done; 1 a comparison failed; 2 bad usage or bad input; 3 the simulation could not go on; 4 a file "
    "could not be read or "
    "written; 130 interrupted.";
constexpr const char* set_help =
    "override a scene value: /pointer=VALUE, for instance /time/step=0.005; may be repeated";

// A number with nothing behind it, within (least, most].
CLI::Validator above_zero() {
  return CLI::Validator(
      [](std::string& text) -> std::string {
        double value = 0;
        return CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > 0
                   ? ""
                   : "found \"" + text + "\"; allowed: a number of seconds above 0";
      },
      "");
}

CLI::Validator not_negative() {
  return CLI::Validator(
      [](std::string& text) -> std::string {
        double value = 0;
        return CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value >= 0
                   ? ""
                   : "found \"" + text + "\"; allowed: a number >= 0";
      },
      "");
}

// Whole numbers from `least` to `most`.
CLI::Validator whole(long least, long most) {
  return CLI::Validator(
      [least, most](std::string& text) -> std::string {
        long value = 0;
        if (CLI::detail::lexical_cast(text, value) && value >= least && value <= most) return "";
        return "found \"" + text + "\"; allowed: a whole number from " + std::to_string(least) + " to " +
               std::to_string(most);
      },
      "");
}

// One of `names`; the nearest is suggested.
CLI::Validator one_of(const std::vector<std::string>& names) {
  return CLI::Validator(
      [names](std::string& text) -> std::string {
        if (std::find(names.begin(), names.end(), text) != names.end()) return "";
        return "found \"" + text + "\"; allowed: " + suggest(text, names);
      },
      "");
}

class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_usage(const CLI::App* app, std::string name) const override {
    if (app->get_parent() != nullptr) return CLI::Formatter::make_usage(app, name);
    return "Usage: pushforward [SCENE] [--set /POINTER=VALUE]...\n       pushforward COMMAND [OPTIONS]\n";
  }
};

CLI::Option* add_sets(CLI::App& app, std::vector<std::string>& sets) {
  return app.add_option("--set", sets, set_help)->type_name("/POINTER=VALUE")->allow_extra_args(false);
}

void add_run(CLI::App& app, Parsed& parsed) {
  RunOptions& run = parsed.run;
  CLI::App* command = app.add_subcommand("run", "simulate without a window");
  command->add_option("SCENE", run.scene, "scene file, or the name of a shipped scene")->required();
  add_sets(*command, run.sets);
  command->add_option("--until", run.until, "simulate to this time instead of the scene's time.end")
      ->check(above_zero())
      ->type_name("SECONDS");
  command->add_option("--steps", run.steps, "stop after this many steps")
      ->check(whole(0, 1000000000000))
      ->type_name("N");
  command->add_option("--threads", run.threads, "threads; default all; never changes a result")
      ->check(whole(1, 1024))
      ->type_name("N");
  command->add_option("--out", run.out, "folder for stats.csv, summary.json and the files below")->type_name("DIR");
  command->add_flag("--quiet", run.quiet, "only warnings and errors");
  command
      ->add_option("--images", parsed.images,
                   "one PNG a frame, drawn off-screen (--images=1920x1200; default 1280x800)")
      ->type_name("[=WxH]");
  command->add_option("--video", run.video, "the frames as a film (--video=FILE.mp4; needs ffmpeg)")
      ->type_name("FILE.mp4");
  command->add_flag("--energy", run.energy,
                    "energy.csv: the closed account of the energy, by cause; a gradient a stage");
  command->add_flag("--plain", run.plain, "pictures and film without title, colour bar, axes and scale");
  std::vector<std::string> formats;
  for (const ExportFormat& format : export_formats()) formats.emplace_back(format.name);
  command->add_option("--export", run.export_format, "particles (and with vtk the active grid), one file a frame")
      ->check(one_of(formats))
      ->type_name("vtk|ply|csv");
  command->add_option("--checkpoint-every", run.checkpoint_every, "save the whole state, every so much simulated time")
      ->check(above_zero())
      ->type_name("SECONDS");
  command->add_option("--resume", run.resume, "go on from a checkpoint of the same scene")->type_name("FILE");
  command->footer(exit_statuses);
}

void add_bench(CLI::App& app, BenchOptions& bench) {
  CLI::App* command = app.add_subcommand(
      "bench", "kernels and whole steps, next to this machine's own bandwidth and multiply-add rate");
  command->add_option("--json", bench.json, "the measurements as a file")->type_name("FILE");
  command->add_option("--threads", bench.threads, "threads of the kernels; default 1")
      ->check(whole(1, 1024))
      ->type_name("N");
  command->add_option("--particles", bench.particles, "in each case, about; default 100000 in 2D, 500000 in 3D")
      ->check(whole(100, 100000000))
      ->type_name("N");
  command->add_option("--dimension", bench.dimension, "only this one")->check(whole(2, 3))->type_name("2|3");
  std::vector<std::string> names;
  for (const BasisInfo& basis : bases()) names.emplace_back(basis.name);
  command->add_option("--basis", bench.basis, "only this one")->check(one_of(names))->type_name("NAME");
  command->add_flag("--quick", bench.quick, "small and short: a look, not a measurement");
}

void add_study(CLI::App& app, StudyRunOptions& study) {
  CLI::App* command = app.add_subcommand("study", "sweep: speed against accuracy, stability maps");
  command->add_option("STUDY", study.studies, "study files, or names of shipped studies")->required();
  command->add_option("--out", study.out, "folder for results.csv, charts and best.json; a study cut off goes on there")
      ->required()
      ->type_name("DIR");
  command->add_option("--jobs", study.jobs, "runs at a time, where they are not timed; default 1")
      ->check(whole(1, 1024))
      ->type_name("N");
  command->add_flag("--fresh", study.fresh, "replace what an earlier study left in the folder");
  command->add_flag("--quiet", study.quiet, "only warnings and errors");
  command->footer(exit_statuses);
}

void add_verify(CLI::App& app, VerifyOptions& verify) {
  CLI::App* command = app.add_subcommand("verify", "cases with known answers: error, observed order, pass or fail");
  command->add_option("NAME", verify.cases,
                      "cases to run, \"quick\" for the short ones, \"failures\" for the gallery of failures, or files; "
                      "default all but these");
  command->add_flag("--list", verify.list, "the cases, one first on each line");
  command->add_option("--json", verify.json, "write the results there, too")->type_name("FILE");
  command->add_option("--out", verify.out, "keep each case's results.csv and charts in a folder of its name there")
      ->type_name("DIR");
  command->footer(
      "A case is a study file with checks (docs/verification.md). Exit status: 0 all passed; 1 a check "
      "failed;\n2 bad input; 4 a file could not be read or written; 130 interrupted.");
}

void add_compare(CLI::App& app, CompareOptions& compare) {
  CLI::App* command = app.add_subcommand("compare", "two run folders, field by field and in time");
  command->add_option("A", compare.a, "folder that run --out wrote")->required();
  command->add_option("B", compare.b, "the other one")->required();
  command
      ->add_option("--tolerance", compare.tolerance,
                   "largest relative difference that still passes; default 0: the same numbers")
      ->check(not_negative())
      ->type_name("T");
  command->footer(
      "Each field's largest difference, relative to the largest value it has in either run (positions: to the largest\n"
      "displacement), and when it was. Rows are matched in time, exported particles one by one. Wall times are left\n"
      "out; iterations, step sizes and errors against an exact motion are shown but not judged. Exit status: 0 within "
      "the tolerance; 1 above it; 2 bad input; 4 a file could not be read.");
}

void add_chart(CLI::App& app, Parsed& parsed) {
  TableChart& chart = parsed.chart.chart;
  CLI::App* command = app.add_subcommand("chart", "columns of CSV files against each other, as a picture");
  command->add_option("TABLE", chart.tables, "CSV files with a header, or folders that run --out wrote")->required();
  command->add_option("--x", chart.x, "column of the horizontal axis; default time")
      ->default_val("time")
      ->type_name("COLUMN");
  command->add_option("--y", chart.y, "columns of the vertical axis, separated by commas")
      ->required()
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("COLUMN[,COLUMN]");
  command->add_option("--lines", chart.lines, "a line for each value of this column")->type_name("COLUMN");
  command->add_option("--out", parsed.chart.out, "the picture, or the points")
      ->required()
      ->type_name("FILE.svg|png|csv");
  command->add_flag("--log-x", chart.log_x, "logarithmic");
  command->add_flag("--log-y", chart.log_y, "logarithmic");
  command->add_option("--title", chart.title, "above the chart");
  command->add_option("--subtitle", chart.subtitle, "below the title");
  command->add_option("--x-title", chart.x_title, "of the axis, for instance \"CPU time [s]\"");
  command->add_option("--y-title", chart.y_title, "of the axis");
  command->add_option("--slope", chart.slopes, "a triangle of this slope; may be repeated; wants both axes logarithmic")
      ->allow_extra_args(false)
      ->type_name("P");
  command->add_flag("--pareto", chart.pareto, "ring the points that no other beats in both x and y");
  command->add_option("--size", parsed.chart_size, "default 820x500; a PNG has twice as many pixels")->type_name("WxH");
  command->add_flag("--dark", parsed.chart.dark, "light on dark");
  command->footer(
      "pushforward run welcome --out out && pushforward chart out --y kinetic_energy,elastic_energy --out energy.svg");
}

void add_advise(CLI::App& app, AdviseOptions& advise) {
  CLI::App* command = app.add_subcommand(
      "advise", "no more than a scene needs: settings that are cheaper and as exact, measured by trials");
  command->add_option("SCENE", advise.scene, "scene file, or the name of a shipped scene")->required();
  add_sets(*command, advise.sets);
  command->add_option("--at", advise.at, "simulated time to begin the trials at; default half of /time/end")
      ->check(not_negative())
      ->type_name("SECONDS");
  command->add_option("--threads", advise.threads, "default all hardware threads; never changes a result")
      ->check(whole(1, 1024))
      ->type_name("N");
  command->add_option("--json", advise.json, "every trial, as a file")->type_name("FILE");
  command->footer(exit_statuses);
}

}  // namespace

void declare_options(CLI::App& app, Parsed& parsed) {
  app.add_option("SCENE", parsed.scene, "scene file, or the name of a shipped scene");
  add_sets(app, parsed.sets);
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_help_flag("--help,-h", "this text; each subcommand has its own");
  app.add_flag("--reset-settings", parsed.reset_settings, "the window as at first: theme, sizes, recent files");
  app.add_flag("--version", parsed.version, "version, commit and compiler");
  app.footer(exit_statuses);
  app.require_subcommand(0, 1);
  add_run(app, parsed);
  add_bench(app, parsed.bench);
  CLI::App* check = app.add_subcommand("check", "validate scenes: every problem found, not just the first");
  check->add_option("SCENE", parsed.files, "scene files")->required();
  add_study(app, parsed.study);
  add_verify(app, parsed.verify);
  add_compare(app, parsed.compare);
  add_chart(app, parsed);
  add_advise(app, parsed.advise);
  CLI::App* list = app.add_subcommand("list", "names that a scene may use, one first on each line");
  list->add_option("KIND", parsed.kind, "what to list")->required()->check(one_of(list_kinds()));
  app.add_subcommand("schema", "JSON Schema of the scene file");
}

PictureSize parse_size(const std::string& text, const char* option) {
  PictureSize size;
  int used = 0;
  constexpr int least = 16, most = 16384;
  if (std::sscanf(text.c_str(), "%dx%d%n", &size.width, &size.height, &used) != 2 ||
      used != static_cast<int>(text.size()) || std::min(size.width, size.height) < least ||
      std::max(size.width, size.height) > most)
    throw CLI::ValidationError(option, "found \"" + text + "\"; allowed: WIDTHxHEIGHT, each from 16 to 16384 pixels");
  return size;
}

}  // namespace pf::app
