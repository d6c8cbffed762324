#include "app/compare/lanes.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "app/recording.hpp"
#include "app/widgets/setting_help.hpp"
#include "core/live_edit.hpp"
#include "core/params/problem.hpp"

namespace pf::app {
namespace {

constexpr double same_time = 1e-9;

/// The window and its own run need some, too.
constexpr double memory_share = 0.7;

void check_memory(const std::vector<Lane>& lanes) {
  double needed = 0;
  for (const Lane& lane : lanes) needed += estimated_memory(lane.scene);
  const double there = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  if (needed <= memory_share * there) return;
  char text[160];
  std::snprintf(text, sizeof text, "%zu lanes of this scene need about %.1f GB", lanes.size(), needed / 1e9);
  char allowed[80];
  std::snprintf(allowed, sizeof allowed, "%.1f GB of the machine's %.1f", memory_share * there / 1e9, there / 1e9);
  throw InputError("", {{"", text, allowed}});
}

LaneSample sample(std::size_t lane, const StepReport& r) {
  LaneSample s{.lane = lane, .time = r.time, .dt = r.dt};
  s.kinetic = r.balance.kinetic;
  s.elastic = r.balance.elastic;
  s.potential = r.balance.potential;
  s.total = r.balance.total();
  s.momentum = r.balance.momentum.norm();
  s.iterations = static_cast<int>(r.newton.size());
  s.wall_ms = r.ms.total;
  return s;
}

}  // namespace

double common_interval(const std::vector<Scene>& scenes) {
  double step = 0, frame = 0;
  for (const Scene& scene : scenes) {
    step = std::max(step, scene.time.step);
    frame = std::max(frame, scene.time.frame.value_or(scene.time.step));
  }
  return step * std::max(1.0, std::ceil(frame / step - same_time));
}

LaneSet::LaneSet(int threads, SimulationFactory factory) : factory_(std::move(factory)) {
  options_.threads = threads;
}

Lane LaneSet::made(const Scene& base, const LaneSpec& spec) const {
  Lane lane;
  lane.spec = spec;
  lane.scene = edited(base, spec.edits);
  return lane;
}

void LaneSet::start(Lane& lane) const {
  lane.applied = lane.scene;
  lane.frame = 0;
  lane.failure.clear();
  lane.waits_for_reset = false;
  lane.history.clear();
  lane.apart.clear();
  lane.simulation.reset();
  try {
    lane.simulation = factory_(lane.scene, options_);
    lane.events.emplace(lane.scene);
    lane.history.push_back(sample(0, lane.simulation->report()));
  } catch (const std::exception& error) {
    lane.failure = error.what();
  }
}

void LaneSet::open(const Scene& base, const std::vector<LaneSpec>& specs) {
  std::vector<Lane> fresh;
  fresh.reserve(specs.size());
  for (const LaneSpec& spec : specs) fresh.push_back(made(base, spec));
  check_memory(fresh);
  lanes_ = std::move(fresh);
  reset();
}

void LaneSet::change(const Scene& base, const std::vector<LaneSpec>& specs) {
  std::vector<Lane> next;
  std::vector<Scene> scenes;
  for (const LaneSpec& spec : specs) {
    next.push_back(made(base, spec));
    scenes.push_back(next.back().scene);
  }
  check_memory(next);
  const bool same_first = !lanes_.empty() && !next.empty() && lanes_.front().scene == next.front().scene;
  if (edited_ || !same_first || waits_for_reset() || common_interval(scenes) != interval_) {
    lanes_ = std::move(next);
    return reset();
  }
  for (Lane& lane : next) {
    const auto old = std::find_if(lanes_.begin(), lanes_.end(),
                                  [&](const Lane& l) { return l.simulation && l.scene == lane.scene; });
    if (old == lanes_.end()) {
      start(lane);
      continue;
    }
    const LaneSpec spec = lane.spec;
    lane = std::move(*old);
    lane.spec = spec;
  }
  lanes_ = std::move(next);
  number();
}

void LaneSet::reset() {
  std::vector<Scene> scenes;
  for (const Lane& lane : lanes_) scenes.push_back(lane.scene);
  interval_ = scenes.empty() ? 0 : common_interval(scenes);
  edited_ = false;
  for (Lane& lane : lanes_) lane.simulation.reset();  // first: old and new need not fit side by side
  for (Lane& lane : lanes_) start(lane);
  number();
}

void LaneSet::number() {
  for (std::size_t k = 0; k < lanes_.size(); ++k) {
    for (LaneSample& s : lanes_[k].history) s.lane = k;
    for (LaneDistance& d : lanes_[k].apart) d.lane = k;
  }
}

void LaneSet::edit(const Scene& base) {
  for (Lane& lane : lanes_) {
    Scene next;
    try {
      next = edited(base, lane.spec.edits);
    } catch (const InputError& error) {
      lane.failure = "The change does not fit what this lane has of its own: " + problem_text(error.problems());
      continue;
    }
    const std::vector<Edit> changes = only(difference(lane.applied, next), Applies::live);
    lane.scene = next;
    bool taken = changes.empty() || !lane.simulation;
    if (!taken) {
      lane.applied = edited(lane.applied, changes);
      try {
        taken = lane.simulation->apply(edited_live(lane.simulation->scene(), changes));
      } catch (const InputError&) {
        taken = false;  // does not fit what the run's own events made of the scene
      }
      edited_ = true;
      lane.failure.clear();  // what was changed may be what it waited for
    }
    lane.waits_for_reset |= !taken;
    lane.waits_for_reset |= !only(difference(lane.applied, next), Applies::reset).empty();
  }
}

double LaneSet::end() const {
  double earliest = lanes_.front().scene.time.end;
  for (const Lane& lane : lanes_) earliest = std::min(earliest, lane.scene.time.end);
  return earliest;
}

const Lane* LaneSet::behind() const {
  const Lane* last = nullptr;
  for (const Lane& lane : lanes_)
    if (lane.failure.empty() && (!last || lane.frame < last->frame)) last = &lane;
  return last;
}

bool LaneSet::level() const {
  const Lane* last = behind();
  return std::all_of(lanes_.begin(), lanes_.end(),
                     [&](const Lane& l) { return !l.failure.empty() || l.frame == last->frame; });
}

long LaneSet::frame() const {
  const Lane* last = behind();
  return last ? last->frame : 0;
}

double LaneSet::time() const {
  const Lane* last = behind();
  return last ? std::min(static_cast<double>(last->frame) * interval_, end()) : 0;
}

bool LaneSet::finished() const {
  const Lane* last = behind();
  return !last || (level() && time() >= end() - same_time * interval_);
}

bool LaneSet::waits_for_reset() const {
  return std::any_of(lanes_.begin(), lanes_.end(), [](const Lane& l) { return l.waits_for_reset; });
}

bool LaneSet::advance(const std::atomic<bool>* cancel) {
  if (lanes_.empty() || finished()) return false;
  Lane& lane = lanes_[static_cast<std::size_t>(behind() - lanes_.data())];
  const std::size_t index = static_cast<std::size_t>(&lane - lanes_.data());
  const double target = std::min(static_cast<double>(lane.frame + 1) * interval_, end());
  Simulation& simulation = *lane.simulation;
  try {
    for (;;) {
      lane.events->apply_due(simulation);
      simulation.set_end(target);
      const StepReport& report = simulation.step(cancel);
      if (report.status == StepStatus::cancelled) return false;
      if (report.status == StepStatus::failed) {
        lane.failure = report.failure;
        return true;
      }
      if (report.status == StepStatus::finished) break;
      lane.history.push_back(sample(index, report));
    }
  } catch (const std::exception& error) {
    lane.failure = error.what();
    return true;
  }
  ++lane.frame;
  return true;
}

std::vector<float> distances(const Snapshot& snapshot, const Snapshot& reference) {
  const auto d = static_cast<std::size_t>(reference.dimension);
  // Of those that came some may have been cut away, here or there; where others came, ids mean nothing.
  const auto came = [](const Snapshot& s) { return s.particles + s.report.strokes.cut; };
  if (came(snapshot) != came(reference) || snapshot.dimension != reference.dimension) return {};
  std::uint32_t last = 0;
  for (const std::uint32_t id : reference.id) last = std::max(last, id);
  constexpr auto nobody = static_cast<std::size_t>(-1);
  std::vector<std::size_t> place(static_cast<std::size_t>(last) + 1, nobody);
  for (std::size_t p = 0; p < reference.particles; ++p) place[reference.id[p]] = p;
  std::vector<float> distance(snapshot.particles);
  for (std::size_t p = 0; p < snapshot.particles; ++p) {
    const std::uint32_t id = snapshot.id[p];
    if (id > last || place[id] == nobody) {
      distance[p] = std::numeric_limits<float>::quiet_NaN();  // cut away there, or never came
      continue;
    }
    double sum = 0;
    for (std::size_t a = 0; a < d; ++a) {
      const double apart = snapshot.x[d * p + a] - reference.x[d * place[id] + a];
      sum += apart * apart;
    }
    distance[p] = static_cast<float>(std::sqrt(sum));
  }
  return distance;
}

LaneDistance summed(const Snapshot& snapshot, const std::vector<float>& distance, std::size_t lane) {
  LaneDistance out{.lane = lane, .time = snapshot.report.time};
  double volume = 0, sum = 0;
  for (std::size_t p = 0; p < distance.size(); ++p) {
    if (std::isnan(distance[p])) continue;
    const double V = static_cast<double>(snapshot.volume0[p]), e = static_cast<double>(distance[p]);
    volume += V;
    sum += V * e * e;
    out.max = std::max(out.max, e);
  }
  out.rms = volume > 0 ? std::sqrt(sum / volume) : 0;
  return out;
}

}  // namespace pf::app
