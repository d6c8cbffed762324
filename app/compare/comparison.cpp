#include "app/compare/comparison.hpp"

#include <algorithm>
#include <utility>

#include "app/widgets/setting_help.hpp"
#include "core/params/problem.hpp"

namespace pf::app {

Comparison::Comparison(int threads, SimulationFactory factory) : lanes_(threads, std::move(factory)) {
  thread_ = std::jthread([this] { loop(); });
}

Comparison::~Comparison() {
  {
    const std::lock_guard lock(mutex_);
    quitting_ = true;
    cancel_ = true;
  }
  came_.notify_one();
  thread_.join();
}

void Comparison::post(std::function<void()> what, bool cancel) {
  {
    const std::lock_guard lock(mutex_);
    posted_.push_back(std::move(what));
    if (cancel) cancel_ = true;
  }
  came_.notify_one();
}

void Comparison::tell(const std::function<void()>& what) {
  std::function<void()> call;
  {
    const std::lock_guard lock(mutex_);
    what();
    status_.state = state_;
    status_.time = lanes_.time();
    status_.interval = lanes_.interval();
    status_.frame = lanes_.frame();
    status_.catching_up = state_ != CompareState::closed && !lanes_.level();
    status_.waits_for_reset = lanes_.waits_for_reset();
    call = wake_;
  }
  if (call) call();
}

bool Comparison::may_advance() const {
  if (suspended_ || state_ == CompareState::closed || lanes_.finished()) return false;
  return state_ == CompareState::running || single_ || !lanes_.level();
}

void Comparison::loop() {
  for (;;) {
    std::vector<std::function<void()>> taken;
    std::optional<Scene> edited;
    {
      std::unique_lock lock(mutex_);
      const auto something = [this] { return quitting_ || edit_ || !posted_.empty(); };
      const bool paced = state_ == CompareState::running && lanes_.level() && !single_;
      if (!may_advance()) {
        came_.wait(lock, something);
      } else if (paced) {
        came_.wait_until(lock, pacer_.due(lanes_.time(), Clock::now()), something);
      }
      if (quitting_) return;
      taken.swap(posted_);
      edited.swap(edit_);
      cancel_ = false;  // whoever asked for it posted something
    }
    for (const auto& work : taken) work();
    if (edited && state_ != CompareState::closed) {
      lanes_.edit(*edited);
      if (state_ == CompareState::finished && !lanes_.finished()) state_ = CompareState::paused;
      publish(false);
    }
    const bool paced = state_ == CompareState::running && lanes_.level() && !single_;
    if (may_advance() && (!paced || Clock::now() >= pacer_.due(lanes_.time(), Clock::now()))) advance();
  }
}

void Comparison::advance() {
  std::vector<std::size_t> had;
  for (const Lane& lane : lanes_.lanes()) had.push_back(lane.history.size());
  const bool whole = lanes_.advance(&cancel_);
  {
    const std::lock_guard lock(mutex_);
    for (std::size_t k = 0; k < had.size(); ++k) {
      const auto& all = lanes_.lanes()[k].history;
      news_.samples.insert(news_.samples.end(), all.begin() + static_cast<std::ptrdiff_t>(had[k]), all.end());
    }
  }
  if (!whole || !lanes_.level()) return;
  single_ = false;
  pacer_.reached(lanes_.time(), Clock::now());
  if (lanes_.finished()) state_ = CompareState::finished;
  publish(true);
}

void Comparison::renew() {
  ComparisonNews all{.run = 0, .samples = {}, .distances = {}};
  for (const Lane& lane : lanes_.lanes()) {
    all.samples.insert(all.samples.end(), lane.history.begin(), lane.history.end());
    all.distances.insert(all.distances.end(), lane.apart.begin(), lane.apart.end());
  }
  tell([&] {
    all.run = ++status_.run;
    news_ = std::move(all);
    if (lanes_.lanes().empty()) frame_.reset();
  });
}

void Comparison::publish(bool news) {
  auto fresh = std::make_shared<ComparisonFrame>();
  fresh->time = lanes_.time();
  fresh->interval = lanes_.interval();
  fresh->number = lanes_.frame();
  fresh->at_end = lanes_.finished();
  std::vector<LaneDistance> apart;
  std::shared_ptr<Snapshot> first;
  for (std::size_t k = 0; k < lanes_.lanes().size(); ++k) {
    const Lane& lane = lanes_.lanes()[k];
    LaneFrame frame;
    frame.name = lane.spec.name;
    frame.failure = lane.failure;
    if (lane.simulation) {
      const std::shared_ptr<Snapshot> snapshot = pool_.take();
      lane.simulation->capture(request_, *snapshot);
      frame.steps = snapshot->report.step;
      if (k == 0) first = snapshot;
      std::vector<float> values = first ? distances(*snapshot, *first) : std::vector<float>();
      if (!values.empty()) frame.distance = summed(*snapshot, values, k);
      const bool first_time = lane.apart.empty() && lanes_.level();
      if ((news || first_time) && frame.distance && lane.failure.empty()) apart.push_back(*frame.distance);
      if (distance_) {
        values.resize(snapshot->particles);
        snapshot->field[static_cast<std::size_t>(Field::error)] = std::move(values);
      }
      frame.snapshot = snapshot;
    }
    fresh->lanes.push_back(std::move(frame));
  }
  for (const LaneDistance& d : apart) lanes_.measured(d);
  tell([&] {
    fresh->run = status_.run;
    frame_ = fresh;
    news_.distances.insert(news_.distances.end(), apart.begin(), apart.end());
  });
}

void Comparison::begin(bool keep_running) {
  state_ = lanes_.lanes().empty() ? CompareState::closed : keep_running ? CompareState::running : CompareState::paused;
  single_ = false;
  pacer_.set_rate(rate_, lanes_.time(), Clock::now());
}

void Comparison::set_lanes(const Scene& base, const std::vector<LaneSpec>& specs) {
  {
    const std::lock_guard lock(mutex_);
    edit_.reset();  // of what was shown before; `base` has it
    status_.refusal.clear();
    if (!specs.empty() && status_.state == CompareState::closed) status_.state = CompareState::loading;
  }
  post(
      [this, base, specs] {
        const bool running = state_ == CompareState::running;
        std::string refusal;
        try {
          if (specs.empty() || lanes_.lanes().empty())
            lanes_.open(base, specs);
          else
            lanes_.change(base, specs);
        } catch (const InputError& error) {
          refusal = problem_text(error.problems());
        }
        begin(running);
        renew();
        tell([&] { status_.refusal = refusal; });
        if (state_ != CompareState::closed) publish(false);
      },
      true);
}

void Comparison::run() {
  post(
      [this] {
        if (state_ == CompareState::closed) return;
        if (lanes_.finished()) {
          lanes_.reset();
          renew();
        }
        begin(true);
        publish(false);
      },
      false);
}

void Comparison::pause() {
  post(
      [this] {
        if (state_ == CompareState::running) state_ = CompareState::paused;
        single_ = false;
        tell([] {});
      },
      true);
}

void Comparison::step() {
  post(
      [this] {
        if (state_ == CompareState::closed || state_ == CompareState::finished) return;
        state_ = CompareState::paused;
        single_ = true;
        tell([] {});
      },
      false);
}

void Comparison::reset() {
  post(
      [this] {
        if (state_ == CompareState::closed) return;
        lanes_.reset();
        begin(state_ == CompareState::running);
        renew();
        publish(false);
      },
      true);
}

void Comparison::edit(const Scene& base) {
  {
    const std::lock_guard lock(mutex_);
    edit_ = base;
  }
  came_.notify_one();
}

void Comparison::suspend(bool on) {
  post(
      [this, on] {
        suspended_ = on;
        pacer_.start(lanes_.time(), Clock::now());
      },
      on);
}

void Comparison::set_rate(double simulated_per_wall) {
  post(
      [this, simulated_per_wall] {
        rate_ = simulated_per_wall;
        pacer_.set_rate(rate_, lanes_.time(), Clock::now());
      },
      false);
}

void Comparison::request(const SnapshotRequest& what, bool distance) {
  post(
      [this, what, distance] {
        request_ = what;
        distance_ = distance;
        if (state_ != CompareState::closed && lanes_.level()) publish(false);
      },
      false);
}

void Comparison::set_wake(std::function<void()> wake) {
  const std::lock_guard lock(mutex_);
  wake_ = std::move(wake);
}

ComparisonStatus Comparison::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

std::shared_ptr<const ComparisonFrame> Comparison::frame() const {
  const std::lock_guard lock(mutex_);
  return frame_;
}

ComparisonNews Comparison::news() {
  const std::lock_guard lock(mutex_);
  ComparisonNews out = std::move(news_);
  news_ = {.run = status_.run, .samples = {}, .distances = {}};
  return out;
}

}  // namespace pf::app
