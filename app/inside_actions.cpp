// The window's part in looking inside: what is asked of the session, and the step that is played slowly.
#include <algorithm>
#include <chrono>

#include "app/inside/step_player.hpp"
#include "app/workbench.hpp"
#include "core/look.hpp"

namespace pf::app {

namespace {

/// What is watched if the user has chosen nothing: a particle where much happens, and the node that it is nearest to.
void choose_watched(AppContext& context) {
  const StepPlayer& player = *context.slow;
  const StepRecord& r = player.record();
  if (r.id.empty()) return;
  if (!context.selected_particle || !player.find_particle(*context.selected_particle))
    context.selected_particle = player.remarkable_particle();
  const auto p = player.find_particle(*context.selected_particle);
  if (!p || (context.selected_node && player.find_node(*context.selected_node))) return;
  const std::vector<NodeWeight> nodes = recorded_weights(r, *p);
  const auto heaviest =
      std::max_element(nodes.begin(), nodes.end(), [](const auto& a, const auto& b) { return a.w < b.w; });
  if (heaviest != nodes.end()) context.selected_node = heaviest->node;
}

}  // namespace

void Workbench::follow_slow_step() {
  if (auto step = session_.taken_apart()) {
    const auto before = context_.slow;
    context_.slow = std::make_shared<StepPlayer>(std::move(*step), context_.scene);
    if (before) {
      context_.slow->speed = before->speed;
      context_.slow->set_magnification(before->magnification());
    }
    choose_watched(context_);
    played_at_ = Clock::now();
    settle_ = 3;
  }
  if (!context_.slow) return;
  // Whatever goes on with the run ends the show.
  if (context_.status.state == RunState::running || context_.status.state == RunState::loading ||
      context_.status.target >= 0)
    return close_slow_step();
  const auto now = Clock::now();
  // A window that was not drawn for a while does not jump.
  context_.slow->advance(std::min(0.1, std::chrono::duration<double>(now - played_at_).count()));
  played_at_ = now;
  if (context_.snapshot) context_.snapshot = context_.slow->snapshot();
}

void Workbench::close_slow_step() {
  if (!context_.slow) return;
  context_.slow.reset();
  context_.snapshot = session_.snapshot();
  settle_ = 3;
}

void Workbench::watch() {
  const bool wanted =
      context_.wants_record || context_.selected_node.has_value() || context_.view.field == Field::node_residual;
  const RecordLevel level = wanted ? RecordLevel::residuals : RecordLevel::none;
  if (level == watched_) return;
  watched_ = level;
  session_.watch(level);
}

void Workbench::follow_selection() {
  // A particle may have been cut away, or belong to a body that has not come yet in the past that is shown.
  if (context_.selected_particle && context_.snapshot && asked_about_ != context_.snapshot) {
    const auto& ids = context_.snapshot->id;
    if (std::find(ids.begin(), ids.end(), *context_.selected_particle) == ids.end()) context_.selected_particle.reset();
  }
  const LookQuestion question{context_.selected_particle, context_.selected_node};
  if (!question.particle) context_.inspected.reset();
  if (!question.particle && !question.node) {
    context_.looked.reset();
    asked_ = {};
    return;
  }
  if (asked_ != question || asked_about_ != context_.snapshot) {
    if (asked_.particle != question.particle) context_.inspected.reset();
    asked_ = question;
    asked_about_ = context_.snapshot;
    session_.look(question);
  }
  if (auto answer = session_.looked()) {
    context_.looked = std::move(answer);
    const auto& particle = context_.looked->particle;
    if (particle && particle->state.id == question.particle) context_.inspected = particle->state;
    settle_ = std::max(settle_, 1);
  }
}

}  // namespace pf::app
