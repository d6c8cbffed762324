#include "app/compare/desk.hpp"

#include <algorithm>

#include "app/gl_view.hpp"
#include "app/studies/describe.hpp"
#include "app/studies/draft.hpp"
#include "app/widgets/setting_help.hpp"
#include "core/params/problem.hpp"
#include "core/scene/scene_io.hpp"
#include "render/picture.hpp"

namespace pf::app {

CompareDesk& compare_of(AppContext& context) {
  if (!context.compare) context.compare = std::make_shared<CompareDesk>(context);
  return *context.compare;
}

CompareDesk::CompareDesk(AppContext& context) : comparison(context.threads) {
  comparison.set_wake(context.wake);
}

Scene CompareDesk::scene_of(const AppContext& context, const LaneSpec& lane) {
  return edited(context.scene, lane.edits);
}

std::string CompareDesk::name_of(const Scene& scene, const std::string& pointer, const nlohmann::json& value) {
  const Setting* setting = find_setting(pointer);
  const std::string text = setting ? value_text(nlohmann::ordered_json(value), *setting) : value.dump();
  if (pointer == "/integrator/type" || pointer == "/transfer/type") return text;
  return setting_title(scene, pointer) + " " + text;
}

std::vector<LaneProposal> CompareDesk::proposals(const Scene& scene) const {
  std::vector<LaneProposal> out;
  const bool is_explicit = scene.integrator.type == "symplectic_euler", still = scene.integrator.type == "quasi_static";
  if (!still) out.push_back({"/time/step", is_explicit ? scene.time.step / 2 : scene.time.step / 4});
  if (!is_explicit && !still)
    out.push_back(
        {"/integrator/type", scene.integrator.type == "backward_euler" ? "implicit_midpoint" : "backward_euler"});
  if (!still) out.push_back({"/transfer/type", scene.transfer.type == "apic" ? "pic" : "apic"});
  out.push_back({"/grid/basis", scene.grid.basis == "linear" ? "quadratic" : "linear"});
  std::erase_if(out, [&](const LaneProposal& p) {
    try {
      const Scene next = edited(scene, std::vector<Edit>{{p.pointer, p.value}});
      return std::any_of(lanes.begin(), lanes.end(),
                         [&](const LaneSpec& lane) { return edited(scene, lane.edits) == next; });
    } catch (const InputError&) {
      return true;  // does not go with the scene's other settings
    }
  });
  return out;
}

bool CompareDesk::add(AppContext& context, const std::string& where, const nlohmann::json& value) {
  refusal.clear();
  LaneSpec fresh;
  if (from > 0 && from < lanes.size()) fresh = lanes[from];
  std::erase_if(fresh.edits, [&](const Edit& e) { return e.pointer == where; });
  fresh.edits.push_back({where, value});
  fresh.name.clear();
  for (const Edit& e : fresh.edits)
    fresh.name += (fresh.name.empty() ? "" : ", ") + name_of(context.scene, e.pointer, e.value);
  const std::size_t count = std::max<std::size_t>(lanes.size(), 1);
  if (count >= most_lanes) {
    refusal = "Four lanes are the most: remove one first.";
    return false;
  }
  try {
    const Scene scene = scene_of(context, fresh);
    const bool same = scene == context.scene || std::any_of(lanes.begin(), lanes.end(), [&](const LaneSpec& lane) {
                        return scene == scene_of(context, lane);
                      });
    if (same) refusal = "There is such a lane already: choose another value.";
  } catch (const InputError& error) {
    refusal = problem_text(error.problems());
  }
  if (!refusal.empty()) return false;
  const bool first = lanes.empty();
  if (first) {
    lanes.push_back({"As it is", {}});
    session_run_ = context.status.run;
    context.session.pause();
  }
  lanes.push_back(std::move(fresh));
  curves.resize(lanes.size());
  comparison.set_lanes(context.scene, lanes);
  if (first) comparison.run();
  return true;
}

void CompareDesk::remove(AppContext& context, std::size_t lane) {
  if (lane >= lanes.size()) return;
  lanes.erase(lanes.begin() + static_cast<std::ptrdiff_t>(lane));
  if (lanes.size() < 2) return close(context);
  // The first lane is what the scene says: another one in its place makes the scene its own.
  if (lane < curves.size()) curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(lane));
  from = 0;
  comparison.set_lanes(context.scene, lanes);
}

void CompareDesk::close(AppContext& context) {
  forget();
  context.snapshot = context.session.snapshot();
}

void CompareDesk::forget() {
  if (!lanes.empty()) comparison.set_lanes({}, {});
  lanes.clear();
  curves.clear();
  frame.reset();
  refusal.clear();
  from = 0;
  view = {};
}

void CompareDesk::follow(AppContext& context) {
  if (!active()) return;
  status = comparison.status();
  frame = comparison.frame();
  if (frame && frame->lanes.size() != lanes.size()) frame.reset();  // of the lanes before
  if (!status.refusal.empty()) {
    refusal = status.refusal;
    if (status.state == CompareState::closed) return forget();
  }
  if (context.status.run != session_run_ && context.status.state != RunState::loading) {
    session_run_ = context.status.run;
    comparison.reset();
  }
  if (context.status.state == RunState::running) context.session.pause();  // one of them at a time
  if (suspended_ != context.status.suspended) comparison.suspend(suspended_ = context.status.suspended);
  const SnapshotRequest wanted = snapshot_request(render_options(context, 1));
  if (wanted.fields != requested_.fields || wanted.grid != requested_.grid || wanted.stress != requested_.stress ||
      difference != requested_difference_)
    comparison.request(requested_ = wanted, requested_difference_ = difference);
  const ComparisonNews news = comparison.news();
  if (news.run != run_) {
    run_ = news.run;
    curves.assign(lanes.size(), {});
  }
  for (const LaneSample& s : news.samples) {
    if (s.lane >= curves.size()) continue;
    LaneCurves& c = curves[s.lane];
    c.time.push_back(s.time);
    c.kinetic.push_back(s.kinetic);
    c.elastic.push_back(s.elastic);
    c.total.push_back(s.total);
    c.momentum.push_back(s.momentum);
    if (s.dt == 0) continue;
    c.step_time.push_back(s.time);
    c.iterations.push_back(s.iterations);
    c.wall_ms.push_back(s.wall_ms);
    c.dt.push_back(s.dt);
  }
  for (const LaneDistance& d : news.distances) {
    if (d.lane >= curves.size()) continue;
    curves[d.lane].distance_time.push_back(d.time);
    curves[d.lane].rms.push_back(d.rms);
    curves[d.lane].max.push_back(d.max);
  }
  if (frame && frame->lanes.front().snapshot) context.snapshot = frame->lanes.front().snapshot;
}

}  // namespace pf::app
