#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>

#include "core/advice/advice.hpp"
#include "core/advice/rules.hpp"
#include "core/bases/basis.hpp"
#include "core/integrators/integrator.hpp"
#include "core/live_edit.hpp"
#include "core/params/problem.hpp"
#include "core/studies/watchdog.hpp"
#include "core/work_weights.hpp"

namespace pf {

namespace {

/// A cell is at rest where no particle in it would come further than this many cells in what is left of the run, even
/// if it went on to gain speed as in the span of the trials.
constexpr double rest_threshold = 1e-2;
/// More exact: by this factor, at no more work.
constexpr double more_exact = 0.5;
/// A trial is given up where it has cost this many times the work as it is: it would save nothing. Within a step no
/// work is known: there the clock decides, with more patience, and for all of it where nothing is known yet.
constexpr double hopeless = 1.5, patience = 4, least_patience = 2, longest_reference = 600;  // times, times, s, s
/// Steps of the references, as parts of the scene's own.
constexpr int fine_implicit = 4, fine_otherwise = 8;
constexpr double solved_finely = 1e-2, finest_tolerance = 1e-9;

/// Where the particles are, by id.
struct Place {
  Vec3 x;
  double mass;
};
using Places = std::vector<Place>;
/// At the end of each quarter of the span; of a run with longer steps at its end alone.
using Course = std::vector<Places>;
constexpr int quarters = 4;

Places places(const Simulation& simulation) {
  Places out;
  for (const ParticleState& p : simulation.particles()) out.push_back({p.x, p.mass});
  return out;
}

/// Root mean square over the mass [m].
double distance(const Places& a, const Places& b) {
  double sum = 0, mass = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    sum += a[k].mass * (a[k].x - b[k].x).squaredNorm();
    mass += a[k].mass;
  }
  return std::sqrt(sum / mass);
}

/// The largest where both are known.
double distance(const Course& a, const Course& b) {
  const std::size_t known = std::min(a.size(), b.size());
  double largest = 0;
  for (std::size_t k = 1; k <= known; ++k) largest = std::max(largest, distance(a[a.size() - k], b[b.size() - k]));
  return largest;
}

/// Share of the cells in which nothing moves.
double share_at_rest(const Places& before, const Places& after, double spacing, double spans_left) {
  const double farthest = rest_threshold * spacing / (spans_left * spans_left);
  std::map<std::array<long, 3>, bool> rests;
  for (std::size_t k = 0; k < before.size(); ++k) {
    const Vec3 cell = (before[k].x / spacing).array().floor();
    bool& rest =
        rests.try_emplace({static_cast<long>(cell[0]), static_cast<long>(cell[1]), static_cast<long>(cell[2])}, true)
            .first->second;
    rest = rest && (after[k].x - before[k].x).norm() < farthest;
  }
  const auto resting = std::count_if(rests.begin(), rests.end(), [](const auto& cell) { return cell.second; });
  return static_cast<double>(resting) / static_cast<double>(rests.size());
}

class Advisor {
 public:
  Advisor(const TrialStart& start, const AdviceOptions& options, const std::atomic<bool>* cancel,
          const std::function<void(double)>& progress)
      : start_(start), options_(options), cancel_(cancel), progress_(progress) {
    simulation_ = make_simulation(*start.scene, {.threads = options.threads});
  }

  std::optional<AdviceReport> run() {
    return_to_start();
    report_.time = simulation_->time();
    first_ = places(*simulation_);
    const AdviceFacts facts = gather();
    report_.span = trial_steps(facts) * facts.step;
    std::vector<Trial> trials = proposed(facts);
    // What a reference costs, in trials: it has as many steps as several of them.
    const double fine = fineness(), all = 2.5 * fine + static_cast<double>(trials.size());
    const auto tell = [&](double done) {
      if (progress_) progress_(done / all);
    };
    std::optional<Course> reference, coarser, other;
    Places here;
    double done = 0;
    const auto finish = [&](double cost) { tell(done += cost); };
    reference = fine_run(facts.step / fine, scene().grid.basis);
    finish(fine);
    coarser = fine_run(2 * facts.step / fine, scene().grid.basis);
    finish(fine / 2);
    report_.other_basis = other_basis(scene().grid.basis);
    other = fine_run(2 * facts.step / fine, report_.other_basis);
    finish(fine);
    if (cancelled()) return std::nullopt;
    if (!other) report_.other_basis.clear();
    if (!reference || !coarser) {
      report_.why_none = "The reference, with finer steps, did not come through: " + trouble_;
      report_.trials = {std::move(trials.front())};
      return std::move(report_);
    }
    report_.reference_open = distance(*reference, *coarser);
    if (other) report_.grid_open = distance(*coarser, *other);
    for (Trial& trial : trials) {
      const bool as_it_is = trial.rule.empty();
      const double most = as_it_is ? 0 : hopeless * report_.trials.front().work;
      if (const std::optional<Course> course = go_on(trial, most)) {
        const bool by_other = std::any_of(trial.edits.begin(), trial.edits.end(), [&](const Edit& edit) {
          return edit.pointer == "/grid/basis" && edit.value == report_.other_basis;
        });
        measure(trial, *course, by_other ? *other : *reference);
        if (as_it_is) here = course->back();
      }
      if (cancelled()) return std::nullopt;
      report_.trials.push_back(std::move(trial));
      finish(1);
      if (as_it_is && here.empty()) {
        report_.why_none = "As it is the run does not come through: " + report_.trials.front().trouble;
        return std::move(report_);
      }
    }
    report_.resting = share_at_rest(first_, here, scene().grid.spacing,
                                    std::max(1.0, (scene().time.end - report_.time) / report_.span));
    if (report_.resting == 1) add_rest(*reference);
    judge();
    return std::move(report_);
  }

 private:
  const Scene& scene() const { return *start_.scene; }
  bool cancelled() const { return cancel_ != nullptr && *cancel_; }
  bool is_implicit() const { return find_integrator(scene().integrator.type)->implicit; }
  bool has_inertia() const { return find_integrator(scene().integrator.type)->inertia; }
  int fineness() const { return is_implicit() && has_inertia() ? fine_implicit : fine_otherwise; }

  void return_to_start() {
    if (!simulation_->apply(scene())) simulation_ = make_simulation(scene(), {.threads = options_.threads});
    std::istringstream in(start_.state);
    simulation_->load_state(in);
  }

  AdviceFacts gather() const {
    AdviceFacts facts{scene(), scene().time.step};
    if (scene().time.control != "fixed" && start_.step > 0) facts.step = start_.step;
    facts.explicit_limit = has_inertia() ? simulation_->stable_step() : 0;
    for (const ParticleState& p : simulation_->particles()) {
      // The third row and column of plane strain are the identity's.
      facts.largest_strain = std::max(facts.largest_strain, (p.F - Mat3::Identity()).norm());
    }
    return facts;
  }

  /// The run as it is, then what the rules propose and goes with the scene.
  std::vector<Trial> proposed(const AdviceFacts& facts) const {
    std::vector<Trial> trials{{.rule = {}, .title = "as it is", .sentence = {}, .edits = {}, .trouble = {}}};
    for (const AdviceRule& rule : advice_rules()) {
      for (Proposal& proposal : rule.propose(facts)) {
        try {
          edited_live(scene(), proposal.edits);
        } catch (const InputError&) {
          continue;
        }
        std::string sentence(rule.sentence);
        sentence.replace(sentence.find("{}"), 2, proposal.title);
        trials.push_back({.rule = std::string(rule.name),
                          .title = std::move(proposal.title),
                          .sentence = std::move(sentence),
                          .edits = std::move(proposal.edits),
                          .trouble = {}});
      }
    }
    return trials;
  }

  std::optional<Course> fine_run(double step, std::string_view basis) {
    Trial fine{.rule = {}, .title = {}, .sentence = {}, .edits = {}, .trouble = {}};
    fine.edits = {{"/time/control", "fixed"}, {"/time/step", step}, {"/grid/basis", basis}};
    if (is_implicit()) {
      const double tolerance = std::max(solved_finely * scene().solver.newton_tolerance,
                                        std::min(finest_tolerance, scene().solver.newton_tolerance));
      fine.edits.push_back({"/solver/newton_tolerance", tolerance});
      if (has_inertia()) fine.edits.push_back({"/integrator/type", "tr_bdf2"});
    }
    if (has_inertia())
      fine.edits.push_back({"/transfer", {{"type", "flip"}, {"flip_ratio", 1}, {"velocity_mass", "lumped"}}});
    if (cancelled()) return std::nullopt;
    const std::optional<Course> course = go_on(fine, 0);
    if (!course) trouble_ = fine.trouble;
    return course;
  }

  /// From the start to the end of the span. Nothing where it does not come to its end, or costs more than `most` (0:
  /// whatever it costs).
  std::optional<Course> go_on(Trial& trial, double most) {
    using Clock = std::chrono::steady_clock;
    return_to_start();
    const Scene changed = edited_live(scene(), trial.edits);
    try {
      if (!simulation_->apply(changed)) {
        trial.trouble = "it would need a reset";
        return std::nullopt;
      }
    } catch (const InputError& error) {
      trial.trouble = error.problems().front().found;
      return std::nullopt;
    }
    const int stops = changed.time.step * quarters <= report_.span * (1 + 1e-9) ? quarters : 1;
    const int nodes = find_basis(changed.grid.basis)->nodes_per_axis;
    const double patient =
        most > 0 ? std::max(least_patience, patience * report_.trials.front().wall_ms / 1000) : longest_reference;
    const Watchdog watchdog(patient, cancel_);
    const Clock::time_point begin = Clock::now();
    Course course;
    const auto next_stop = [&] {
      const double share = static_cast<double>(course.size() + 1) / stops;
      simulation_->set_end(report_.time + share * report_.span);
    };
    next_stop();
    for (;;) {
      const StepReport& report = simulation_->step(watchdog.flag());
      if (report.status == StepStatus::finished) {
        course.push_back(places(*simulation_));
        if (static_cast<int>(course.size()) == stops) break;
        next_stop();
        continue;
      }
      if (report.status == StepStatus::cancelled) {
        trial.trouble = "given up after " + std::to_string(std::lround(patient)) + " s";
        return std::nullopt;
      }
      if (report.status == StepStatus::failed) {
        trial.trouble = report.failure;
        return std::nullopt;
      }
      ++trial.steps;
      trial.work += weighted_work(report.work, changed.dimension, nodes);
      const double share = (simulation_->time() - report_.time) / report_.span;
      if (most > 0 && trial.work > most && share < 1 - 1e-9) {
        trial.trouble = "dearer: given up after " + std::to_string(static_cast<int>(100 * share)) + " % of the way";
        return std::nullopt;
      }
    }
    trial.wall_ms = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
    const Places& end = course.back();
    if (!std::all_of(end.begin(), end.end(), [](const Place& p) { return p.x.allFinite(); })) {
      trial.trouble = "it blew up";
      return std::nullopt;
    }
    trial.came_through = true;
    return course;
  }

  void measure(Trial& trial, const Course& course, const Course& reference) const {
    trial.distance = distance(course, reference);
    trial.error = trial.distance + report_.reference_open + report_.grid_open;
  }

  /// What does not move can stay where it is.
  void add_rest(const Course& reference) {
    Trial trial{.rule = "rest",
                .title = "the end, now",
                .sentence = "Let the run end here: nothing moves any more",
                .edits = {{"/time/end", report_.time}},
                .trouble = {}};
    trial.came_through = true;
    measure(trial, {first_}, reference);
    report_.trials.push_back(std::move(trial));
  }

  bool cheaper(const Trial& t) const {
    const Trial& now = report_.trials.front();
    return t.error <= options_.allowed * now.error && t.work <= options_.worthwhile * now.work;
  }
  bool more_exact_for_the_same(const Trial& t) const {
    const Trial& now = report_.trials.front();
    return t.error <= more_exact * now.error && t.work <= now.work;
  }

  /// Of each rule what saves most, or else what gains most.
  void judge() {
    const std::vector<Trial>& trials = report_.trials;
    std::map<std::string, std::size_t> best;
    for (std::size_t k = 1; k < trials.size(); ++k) {
      const Trial& t = trials[k];
      if (!t.came_through || (t.rule != "rest" && !cheaper(t) && !more_exact_for_the_same(t))) continue;
      const auto [at, first] = best.try_emplace(t.rule, k);
      if (first) continue;
      const Trial& other = trials[at->second];
      const bool better = cheaper(t) != cheaper(other) ? cheaper(t)
                          : cheaper(t)                 ? t.work < other.work
                                                       : t.error < other.error;
      if (better) at->second = k;
    }
    for (const auto& [rule, k] : best) report_.advice.push_back(k);
    std::stable_sort(report_.advice.begin(), report_.advice.end(),
                     [&](std::size_t a, std::size_t b) { return trials[a].work < trials[b].work; });
  }

  const TrialStart& start_;
  const AdviceOptions& options_;
  const std::atomic<bool>* cancel_;
  const std::function<void(double)>& progress_;
  std::unique_ptr<Simulation> simulation_;
  AdviceReport report_;
  Places first_;
  std::string trouble_;
};

}  // namespace

std::optional<AdviceReport> advise(const TrialStart& start, const AdviceOptions& options,
                                   const std::atomic<bool>* cancel, const std::function<void(double)>& progress) {
  return Advisor(start, options, cancel, progress).run();
}

std::vector<Edit> inverse(const Scene& scene, const std::vector<Edit>& edits) {
  const nlohmann::json json = to_json(scene);
  std::vector<Edit> back;
  back.reserve(edits.size());
  for (const Edit& edit : edits) back.push_back({edit.pointer, json.at(nlohmann::json::json_pointer(edit.pointer))});
  return back;
}

}  // namespace pf
