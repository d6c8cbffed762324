#include "app/studies/desk.hpp"

#include <algorithm>
#include <cmath>

#include "app/studies/describe.hpp"
#include "app/widgets/units.hpp"
#include "core/params/problem.hpp"
#include "core/studies/reference.hpp"

namespace pf::app {

namespace {

StudyHooks hooks_of(AppContext& context) {
  Session& session = context.session;  // outlives the desk
  return {context.wake, [&session](bool on) { session.suspend(on); },
          [&session] { return session.status().suspended; }};
}

/// A round number in the middle of the errors, on their logarithm.
std::optional<double> middle_error(const StudyResults& results) {
  const auto range = error_range(*results.study, results.rows);
  if (!range) return std::nullopt;
  return rounded(std::sqrt(range->first * range->second), 1);
}

double step_seconds(const AppContext& context) {
  constexpr double usual = 2e-3;
  return context.status.step_ms > 0 ? 1e-3 * context.status.step_ms : usual;
}

}  // namespace

StudyDesk::StudyDesk(AppContext& context)
    : runner(context.study_folder,
             context.study_folder.empty() ? std::filesystem::path() : cache_folder() / "references",
             hooks_of(context)) {}

void StudyDesk::follow(AppContext& context) {
  status = runner.status();
  results = runner.results();
  if (!results || results->study != study_) forget_study();
  if (results && results->version != version_) {
    if (!study_) identity = study_identity(*results->study);
    study_ = results->study;
    version_ = results->version;
    figures = study_figures(*study_, results->rows);
  }
  if (stage_ != status.stage) {
    if (stage_ == StudyStage::running && status.stage == StudyStage::finished && context.notify)
      context.notify("Study finished: " + std::to_string(status.size) + " runs");
    if (status.stage == StudyStage::finished || status.stage == StudyStage::ready) listed = false;
    stage_ = status.stage;
  }
  if (!results) return;
  if (!located || !(located_scene == context.scene)) {
    located = true;
    located_scene = context.scene;
    place = locate(*results->study, context.scene);
  }
}

void StudyDesk::forget_study() {
  study_.reset();
  version_ = 0;
  figures.clear();
  figure = 0;
  view = {};
  place.reset();
  located = false;
  tolerance.reset();
}

void StudyDesk::open(StudyFile file) {
  page = Page::results;
  runner.open(std::move(file), false);
}

void StudyDesk::start_draft(const Scene& scene) {
  page = Page::results;
  runner.open({study_text(draft, scene), scene.name.empty() ? "this scene" : scene.name, {}}, true);
}

void StudyDesk::set_up(const AppContext& context) {
  page = Page::set_up;
  listed = false;
  propose(context, draft.kind);
}

void StudyDesk::propose(const AppContext& context, StudyKind kind) {
  draft = propose_study(context.scene, kind, step_seconds(context));
  drafted_for = context.scene;
  variable = variable_settings(context.scene);
  touched = false;
  typed_axis.clear();
  refused_axis.clear();
}

const StudyFigure* StudyDesk::shown_figure() const {
  if (figures.empty()) return nullptr;
  return &figures[std::min(figure, figures.size() - 1)];
}

const StudyRow* StudyDesk::row_of(std::size_t setting) const {
  if (!results) return nullptr;
  const auto found = std::find_if(results->rows.begin(), results->rows.end(),
                                  [setting](const StudyRow& row) { return row.point == setting; });
  return found == results->rows.end() ? nullptr : &*found;
}

std::optional<Cheapest> StudyDesk::answer() const {
  const std::optional<double> below = bound();
  return below ? cheapest(*results->study, results->rows, *below) : std::nullopt;
}

std::optional<double> StudyDesk::bound() const {
  const std::optional<double> middle = results ? middle_error(*results) : std::nullopt;
  return middle && tolerance ? tolerance : middle;
}

StudyDesk& studies_of(AppContext& context) {
  if (!context.studies) context.studies = std::make_shared<StudyDesk>(context);
  return *context.studies;
}

void load_setting(AppContext& context, std::size_t setting) {
  const StudyDesk& desk = studies_of(context);
  if (!desk.results || !context.adopt) return;
  const Study& study = *desk.results->study;
  try {
    const OpenedSetting opened = open_setting(study, setting, context.scene);
    std::string message = setting_words(study, setting);
    if (opened.differs) message += " – the scene differs from the study's in other settings";
    context.adopt(opened.scene, opened.other_scene, message + " – Ctrl+Z takes it back");
  } catch (const InputError& error) {
    if (context.notify) context.notify("These settings do not go together: " + error.problems().front().found);
  }
}

}  // namespace pf::app
