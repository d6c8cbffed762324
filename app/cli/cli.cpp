// The command line: what may be said, and what is said back when it is wrong.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include "app/cli/commands.hpp"
#include "app/cli/options.hpp"
#include "app/preferences.hpp"
#include "core/build_info.hpp"
#include "core/params/nearest.hpp"
#include "core/params/problem.hpp"

namespace pf::app {

namespace {

void complain(const std::string& text) {
  std::fprintf(stderr, "pushforward: %s\n", text.c_str());
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

// Says for each argument that nobody wanted what was probably meant.
void complain_of_extras(const CLI::App& app) {
  const CLI::App* used = &app;
  if (!app.get_subcommands().empty()) used = app.get_subcommands().front();
  const std::vector<std::string> extras = app.remaining(true);
  const std::vector<std::string> known = option_names(*used);
  bool unknown_option = false;
  for (const std::string& extra : extras) {
    if (!extra.starts_with("-")) continue;
    unknown_option = true;
    const std::string name = extra.substr(0, extra.find('='));
    const std::string near = nearest_name(name, known);
    complain("unknown option " + name + (near.empty() ? "" : "; did you mean " + near + "?"));
  }
  if (unknown_option) {  // other extras are probably its values
    std::string all;
    for (const std::string& option : known) all += " " + option;
    std::fprintf(stderr, "allowed:%s\n", all.c_str());
    return;
  }
  for (const std::string& extra : extras)
    complain("found \"" + extra + "\", one argument too many; see pushforward " +
             (used == &app ? "" : used->get_name() + " ") + "--help");
}

// A first word that is neither a subcommand nor a file: a slip of the pen, or a command that this version lacks.
bool is_unknown_command(const CLI::App& app, const std::string& scene) {
  if (scene.empty() || scene.find_first_of("/.") != std::string::npos || std::filesystem::exists(scene)) return false;
  const std::vector<std::string> scenes = shipped_scenes();
  if (std::find(scenes.begin(), scenes.end(), scene) != scenes.end()) return false;
  std::vector<std::string> commands;
  std::string all;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    commands.push_back(command->get_name());
    all += (all.empty() ? "" : ", ") + command->get_name();
  }
  const std::string near = nearest_name(scene, commands);
  complain("\"" + scene + "\" is neither a command nor a scene file" +
           (near.empty() ? "." : "; did you mean " + near + "?") + " Commands: " + all);
  return true;
}

int dispatch(CLI::App& app, Parsed& parsed) {
  if (app.got_subcommand("run")) {
    if (!parsed.images.empty()) parsed.run.images = parse_size(parsed.images, "--images");
    return run_scene(parsed.run);
  }
  if (app.got_subcommand("check")) return check_scenes(parsed.files);
  if (app.got_subcommand("study")) return run_studies(parsed.study);
  if (app.got_subcommand("verify")) return verify(parsed.verify);
  if (app.got_subcommand("compare")) return compare_folders(parsed.compare);
  if (app.got_subcommand("chart")) {
    if (!parsed.chart_size.empty()) parsed.chart.size = parse_size(parsed.chart_size, "--size");
    return chart_tables(parsed.chart);
  }
  if (app.got_subcommand("list")) return list_names(parsed.kind);
  if (app.got_subcommand("schema")) return print_schema();
  if (app.got_subcommand("advise")) return advise_on(parsed.advise);
  if (app.got_subcommand("bench")) return run_bench(parsed.bench);
  if (is_unknown_command(app, parsed.scene)) return exit_bad_input;
  if (parsed.reset_settings) forget_preferences(default_folders());
  return open_app(parsed.scene, parsed.sets);
}

int parse_and_dispatch(const std::vector<std::string>& arguments) {
  CLI::App app(about, "pushforward");
  Parsed parsed;
  declare_options(app, parsed);
  // CLI11 takes them from the back. A bare --images has the default size and no value of its own.
  std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
  for (std::string& argument : reversed)
    if (argument == "--images") argument = "--images=1280x800";
  try {
    app.parse(std::move(reversed));
    if (parsed.version) {
      std::printf("pushforward %s\n", version_text().c_str());
      return exit_done;
    }
    return dispatch(app, parsed);
  } catch (const CLI::CallForHelp&) {
    const auto used = app.get_subcommands();
    std::cout << (used.empty() ? app.help() : used.front()->help("pushforward")) << std::flush;
    return exit_done;
  } catch (const CLI::ExtrasError&) {
    complain_of_extras(app);
  } catch (const CLI::ParseError& error) {
    complain(error.what());
  }
  return exit_bad_input;
}

}  // namespace

std::string version_text() {
  const BuildInfo build = build_info();
  return std::string(build.version) + " (commit " + std::string(build.commit) + ", " + std::string(build.compiler) +
         ")";
}

int run_command_line(const std::vector<std::string>& arguments) {
  try {
    const int status = parse_and_dispatch(arguments);
    std::cout.flush();
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) throw FileError("stdout could not be written to the end");
    return status;
  } catch (const InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return exit_bad_input;
  } catch (const FileError& error) {
    complain(error.what());
    return exit_file_error;
  } catch (const std::bad_alloc&) {
    complain("out of memory: try fewer particles_per_axis or a larger /grid/spacing");
    return exit_simulation_failed;
  } catch (const std::exception& error) {
    complain(std::string("this should not have happened: ") + error.what());
    return exit_simulation_failed;
  }
}

}  // namespace pf::app
