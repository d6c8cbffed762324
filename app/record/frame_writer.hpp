// Pictures of a run on their way to files: compressed and written by a thread of their own.
#pragma once

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "core/charts/image.hpp"

namespace pf::app {

class FrameWriter {
 public:
  struct Target {
    std::filesystem::path path;     ///< a folder for NNNNNN.png, or the film
    bool film = false;              ///< MP4, by ffmpeg
    double frames_per_second = 30;  ///< of the film
    std::function<void()> wake;     ///< called from the thread when it has got further; may be empty
  };
  /// Throws FileError where the folder cannot be made.
  explicit FrameWriter(Target target);
  ~FrameWriter();  ///< writes what it was given, then ends
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;

  /// There is room for another picture: a slow disc makes the run wait, not memory grow.
  bool room() const;
  /// All pictures of a film get the size of the first: larger ones are cut, smaller ones framed.
  void add(Image image, ImageText text);
  /// No more will come.
  void finish();

  struct Progress {
    long frames = 0;      ///< written
    bool done = false;    ///< all of them, or no more can be
    std::string trouble;  ///< why no more can be written
  };
  Progress progress() const;
  const Target& target() const { return target_; }

 private:
  struct Frame {
    Image image;
    ImageText text;
  };
  void work();

  Target target_;
  mutable std::mutex mutex_;
  std::condition_variable came_;
  std::deque<Frame> waiting_;
  bool finish_ = false;
  Progress progress_;
  std::jthread thread_;  // last: it uses all of the above
};

/// In the middle of a picture of that size: what does not fit is cut, what is missing takes the colour of its corner.
Image framed(const Image& image, int width, int height);

}  // namespace pf::app
