// A film: frames piped to ffmpeg, which is looked for when it is needed.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "core/charts/image.hpp"
#include "render/camera.hpp"

namespace pf::app {

/// Some folder of PATH has ffmpeg.
bool ffmpeg_present();

class Film {
 public:
  /// Starts ffmpeg. Throws InputError where there is none, FileError where it cannot be started or the file not be
  /// written.
  Film(const std::filesystem::path& file, ViewSize size, double frames_per_second);
  ~Film();
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;
  /// `image` has the film's size. Throws FileError, with ffmpeg's words, when it has given up.
  void add(const Image& image);
  /// Waits until the film is complete. Throws FileError, with ffmpeg's words.
  void close();

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  [[noreturn]] void refuse(const std::string& what) const;

  std::filesystem::path file_;
  std::unique_ptr<std::FILE, Closer> words_;  ///< what ffmpeg says
  pid_t process_ = -1;
  int pipe_ = -1;
};

}  // namespace pf::app
