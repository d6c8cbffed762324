#include "app/lessons/rehearse.hpp"

#include <cmath>
#include <memory>

#include "app/lessons/measures.hpp"
#include "core/diagnostics/fields.hpp"
#include "core/simulation.hpp"

namespace pf::app {

namespace {

class Rehearser {
 public:
  Rehearser(const Lesson& lesson, Rehearsal& result) : lesson_(lesson), result_(result) {}

  void play(std::size_t index, const std::function<void(std::size_t, const Constants&)>& page_done) {
    page_ = &lesson_.pages[index];
    where_ = "page " + std::to_string(index + 1) + " (" + page_->title + ")";
    try {
      enter();
      if (page_->slow) take_apart();
      if (!page_->until.empty()) wait();
      const Constants now = values();
      for (const auto& [name, expression] : page_->keep) keep(name, measured(expression, now));
      check(values());
      if (page_done) page_done(index, values());
    } catch (const ExpressionError& error) {
      complain(error.what());
    } catch (const InputError& error) {
      for (const Problem& p : error.problems()) complain(to_string(p));
    }
  }

 private:
  void complain(const std::string& what) { result_.problems.push_back(where_ + ": " + what); }

  void build() {
    simulation_ = make_simulation(scene_, {.threads = 1});
    measures_.begin();
    measures_.add(simulation_->report());
  }

  /// A page's edits as the window applies them: live where they can be, else with a reset.
  void apply(const std::vector<Edit>& edits) {
    if (edits.empty()) return;
    scene_ = edited(scene_, edits);
    if (!simulation_->apply(scene_)) build();
  }

  void enter() {
    if (page_->scene) scene_ = *page_->scene;
    if (page_->scene) build();
    apply(page_->set);
    apply(page_->task);
    if (page_->restart) build();
    if (!page_->highlight.empty()) {
      if (!to_json(scene_).contains(nlohmann::ordered_json::json_pointer(page_->highlight)))
        complain(page_->highlight + " is not in the scene");
    }
  }

  void take_apart() {
    simulation_->set_recording(RecordLevel::all);
    step();
    simulation_->set_recording(RecordLevel::none);
    if (!simulation_->record() || !simulation_->record()->accepted) complain("the step was not recorded");
  }

  bool step() {
    const StepReport& report = simulation_->step();
    ++result_.steps;
    if (report.status == StepStatus::accepted) {
      measures_.add(report);
      return true;
    }
    if (report.status == StepStatus::failed) complain("the run failed: " + report.failure);
    return false;
  }

  void wait() {
    const double limit = page_->limit > 0 ? page_->limit : scene_.time.end;
    const double until = simulation_->time() + limit;
    while (measured(page_->until, values(needs_snapshot(page_->until))) == 0) {
      if (simulation_->time() >= until - 1e-12 || !step()) return complain("\"" + page_->until + "\" never came true");
    }
  }

  Constants values(bool particles = true) {
    Snapshot snapshot;
    SnapshotRequest request;
    request.fields = 0;
    if (particles) simulation_->capture(request, snapshot);
    Constants all = measures_.values(scene_, particles ? &snapshot : nullptr);
    all.insert(all.end(), result_.kept.begin(), result_.kept.end());
    return all;
  }

  void keep(const std::string& name, double value) {
    std::erase_if(result_.kept, [&](const auto& k) { return k.first == name; });
    result_.kept.emplace_back(name, value);
    if (!std::isfinite(value)) complain(name + " is not a finite number");
  }

  void check(const Constants& now) {
    const auto claim = [&](const std::string& condition) {
      if (!condition.empty() && measured(condition, now) == 0) complain("\"" + condition + "\" does not hold");
    };
    for (const std::string& condition : page_->holds) claim(condition);
    for (const LessonLine& line : page_->lines)
      if (!line.formula) with_values(line.text, now);
    if (!page_->question) return;
    claim(page_->question->because);
    with_values(page_->question->text, now);
    for (const std::string& reply : page_->question->replies) with_values(reply, now);
  }

  const Lesson& lesson_;
  Rehearsal& result_;
  const LessonPage* page_ = nullptr;
  std::string where_;
  Scene scene_;
  std::unique_ptr<Simulation> simulation_;
  RunMeasures measures_;
};

}  // namespace

Rehearsal rehearse(const Lesson& lesson, const std::function<void(std::size_t, const Constants&)>& page_done) {
  Rehearsal result;
  Rehearser rehearser(lesson, result);
  for (std::size_t k = 0; k < lesson.pages.size(); ++k) rehearser.play(k, page_done);
  return result;
}

}  // namespace pf::app
