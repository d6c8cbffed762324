// run --images and --video: frames drawn off-screen.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "app/cli/commands.hpp"
#include "core/runner.hpp"

namespace pf::app {

struct FrameOutput {
  PictureSize size;
  std::optional<std::filesystem::path> folder;  ///< NNNNNN.png of each frame goes here
  std::optional<std::filesystem::path> video;   ///< film of all frames
  double frames_per_second = 30;                ///< of the film
  bool overlay = true;                          ///< title, colour bar, axes and scale
};

/// Draws each frame as `view.color_by` says.
class PictureWriter : public RunObserver {
 public:
  /// Throws FileError where nothing can be drawn or written here, InputError where a film is wanted without ffmpeg.
  PictureWriter(const FrameOutput& output, const Scene& scene);
  ~PictureWriter() override;
  void on_frame(const Simulation& simulation, long number) override;
  void on_end(const Simulation& simulation, const RunResult& result) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pf::app
