// pushforward run: a scene without a window.
#include <cstdio>
#include <list>
#include <memory>
#include <thread>

#include "app/cli/commands.hpp"
#include "app/cli/interrupt.hpp"
#include "app/cli/pictures.hpp"
#include "app/cli/progress.hpp"
#include "core/output/checkpoint.hpp"
#include "core/output/energy_account.hpp"
#include "core/output/export.hpp"
#include "core/output/run_folder.hpp"
#include "core/output/stats.hpp"
#include "core/output/summary.hpp"
#include "core/scene/scene_io.hpp"

namespace pf::app {

namespace {

void say(const std::string& text) {
  std::fprintf(stderr, "%s\n", text.c_str());
}

// Outputs that need a folder are refused without one, before anything is computed.
void require_folder(const RunOptions& options) {
  if (options.out) return;
  std::vector<Problem> problems;
  const auto need = [&problems](bool given, const char* option) {
    if (given) problems.push_back({option, "no --out DIR", "--out DIR beside it: it writes files there"});
  };
  need(options.images.has_value(), "--images");
  need(options.export_format.has_value(), "--export");
  need(options.checkpoint_every.has_value(), "--checkpoint-every");
  need(options.energy, "--energy");
  if (!problems.empty()) throw InputError("", problems);
}

Scene load(const RunOptions& options) {
  std::vector<Edit> edits = parse_sets(options.sets);
  if (options.until) edits.push_back({"/time/end", *options.until});
  return load_scene(find_scene(options.scene), edits);
}

int thread_count(const RunOptions& options) {
  const unsigned all = std::max(1u, std::thread::hardware_concurrency());
  return options.threads.value_or(static_cast<int>(all));
}

// Every output that was asked for, in the order in which a state is written.
class Outputs {
 public:
  Outputs(const RunOptions& options, const Scene& scene, const Checkpoint* resumed) : threads_(thread_count(options)) {
    RunFolder folder;
    Kept kept;
    const CheckpointHeader* header = resumed != nullptr ? &resumed->header : nullptr;
    if (options.out) {
      folder.root = *options.out;
      kept = prepare_run_folder(folder, scene, header);
      add<StatsWriter>(folder.stats(), scene, kept.step);
      if (options.energy) add<EnergyWriter>(folder.energy());
      if (!scene.probes.empty()) add<ProbesWriter>(folder.probes(), scene, kept.step);
    }
    if (options.images || options.video) {
      FrameOutput pictures;
      pictures.size = options.images.value_or(PictureSize{});
      if (options.images) pictures.folder = folder.images();
      if (options.video) pictures.video = *options.video;
      pictures.frames_per_second = frame_rate(scene.time);
      pictures.overlay = !options.plain;
      add<PictureWriter>(pictures, scene);
    }
    if (options.export_format)
      add<Exporter>(*find_export_format(*options.export_format), folder.exports(), kept.frames);
    if (options.checkpoint_every)
      add<CheckpointWriter>(folder.checkpoints(), scene, *options.checkpoint_every, header ? header->time : 0.0,
                            kept.step ? header->number + 1 : 0);
    add<Progress>(options.steps, options.quiet);
    summary_ = add<SummaryWriter>(options.out ? folder.summary() : "", scene, threads_);
  }

  void watch(Runner& runner) {
    for (const auto& observer : observers_) runner.add(*observer);
  }
  const SummaryWriter& summary() const { return *summary_; }
  int threads() const { return threads_; }

 private:
  template <class Observer, class... Arguments>
  Observer* add(Arguments&&... arguments) {
    auto made = std::make_unique<Observer>(std::forward<Arguments>(arguments)...);
    Observer* observer = made.get();
    observers_.push_back(std::move(made));
    return observer;
  }

  // Pictures flow by at the speed of the simulated world, as far as players can.
  static double frame_rate(const TimeSettings& time) {
    return std::min(60.0, std::max(1.0, 1 / time.frame.value_or(time.step)));
  }

  int threads_;
  std::vector<std::unique_ptr<RunObserver>> observers_;
  SummaryWriter* summary_ = nullptr;
};

int report(const RunOptions& options, const Simulation& simulation, const RunResult& result, const Outputs& outputs) {
  if (!options.quiet) std::printf("%s\n", outputs.summary().line(simulation, result).c_str());
  if (result.end == RunEnd::interrupted) {
    say("interrupted at t = " + std::to_string(simulation.time()) + " s" +
        (options.out ? "; everything up to here is in " + options.out->string() : ""));
    return exit_interrupted;
  }
  if (result.end == RunEnd::failed) {
    say("the simulation could not go on after step " + std::to_string(simulation.report().step) + ": " +
        result.last_attempt.failure);
    return exit_simulation_failed;
  }
  return exit_done;
}

}  // namespace

int run_scene(const RunOptions& options) {
  require_folder(options);
  const Scene scene = load(options);
  std::optional<Checkpoint> checkpoint;
  if (options.resume) checkpoint = read_checkpoint(*options.resume);
  const std::unique_ptr<Simulation> simulation = make_simulation(scene, {thread_count(options), options.scene});
  simulation->set_ledger(options.energy);
  RunCursor cursor;
  if (checkpoint) {
    resume(*simulation, scene, *checkpoint, options.resume->string());
    cursor = checkpoint->header.cursor;
  }
  const InterruptGuard interrupt;
  Outputs outputs(options, scene, checkpoint ? &*checkpoint : nullptr);
  Runner runner(*simulation, cursor);
  outputs.watch(runner);
  const RunResult result = runner.run({.steps = options.steps}, &interrupt.flag());
  return report(options, *simulation, result, outputs);
}

}  // namespace pf::app
