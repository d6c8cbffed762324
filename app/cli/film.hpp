// A film: frames piped to ffmpeg.
#pragma once

#include <sys/types.h>

#include <filesystem>

#include "app/cli/commands.hpp"
#include "core/charts/image.hpp"

namespace pf::app {

class Film {
 public:
  /// Starts ffmpeg. Throws InputError where there is none, FileError where it cannot be started.
  Film(const std::filesystem::path& file, PictureSize size, double frames_per_second);
  ~Film();
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;
  /// `image` has the film's size. Throws FileError when ffmpeg has given up.
  void add(const Image& image);
  /// Waits until the film is complete. Throws FileError.
  void close();

 private:
  std::filesystem::path file_;
  pid_t process_ = -1;
  int pipe_ = -1;
};

}  // namespace pf::app
