// run --images and --video: frames drawn off-screen.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "app/cli/commands.hpp"
#include "core/runner.hpp"

namespace pf::app {

struct PictureOptions {
  PictureSize size;
  std::optional<std::filesystem::path> folder;  ///< NNNNNN.png of each frame goes here
  std::optional<std::filesystem::path> video;   ///< H.264 film, made by ffmpeg
  double frames_per_second = 30;                ///< of the film
};

class PictureWriter : public RunObserver {
 public:
  /// Throws FileError where nothing can be drawn here, or where ffmpeg is wanted and missing.
  PictureWriter(const PictureOptions& options, const Scene& scene);
  ~PictureWriter() override;
  void on_frame(const Simulation& simulation, long number) override;
  void on_end(const Simulation& simulation, const RunResult& result) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pf::app
