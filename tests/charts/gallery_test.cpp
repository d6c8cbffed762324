// Not run by default: writes the sample charts for people to look at.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>

#include "core/charts/draw.hpp"
#include "tests/charts/sample_charts.hpp"

namespace fs = std::filesystem;

TEST_SUITE("long") {
  TEST_CASE("gallery: every sample chart, light and dark") {
    const char* chosen = std::getenv("PUSHFORWARD_GALLERY");
    const fs::path folder = chosen ? fs::path(chosen) : fs::temp_directory_path() / "pushforward-charts";
    fs::create_directories(folder);
    const std::pair<const char*, pf::Chart> charts[] = {
        {"energy", pf::test::energy_chart()},      {"work-precision", pf::test::work_precision_chart()},
        {"newton", pf::test::convergence_chart()}, {"stability", pf::test::stability_chart()},
        {"phases", pf::test::phase_chart()},       {"field", pf::test::field_chart()}};
    for (const auto& [name, chart] : charts) {
      for (const bool dark : {false, true}) {
        const pf::ChartTheme theme = dark ? pf::dark_theme() : pf::light_theme();
        const fs::path file = folder / (std::string(name) + (dark ? "-dark" : "-light"));
        pf::write_chart_png(chart, theme, 720, 420, file.string() + ".png", 2, {{"Software", "pushforward"}});
        pf::write_chart_svg(chart, theme, 720, 420, file.string() + ".svg");
        CHECK(fs::file_size(file.string() + ".png") > 10000);
      }
    }
    MESSAGE("pictures are in ", folder.string());
  }
}
