#include "core/build_info.hpp"
#include "core/charts/draw.hpp"
#include "core/charts/theme.hpp"
#include "core/studies/study_charts.hpp"

namespace pf {

void write_figures(std::span<const StudyFigure> figures, const Study& study, const std::filesystem::path& folder) {
  constexpr int width = 820, height = 500;
  const BuildInfo build = build_info();
  const ImageText text{{"Software", "pushforward " + std::string(build.version)},
                       {"Commit", std::string(build.commit)},
                       {"Study", study.source},
                       {"Study hash", study_identity(study)}};
  for (const StudyFigure& figure : figures) {
    write_chart_svg(figure.chart, light_theme(), width, height, folder / (figure.name + ".svg"), text);
    write_chart_png(figure.chart, light_theme(), width, height, folder / (figure.name + ".png"), 2, text);
    write_chart_csv(figure.chart, folder / (figure.name + ".csv"));
  }
}

}  // namespace pf
