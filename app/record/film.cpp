#include "app/record/film.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include "core/files.hpp"
#include "core/params/problem.hpp"

extern char** environ;  // NOLINT(readability-redundant-declaration): not every unistd.h has it

namespace pf::app {

namespace {

std::string reason(int error) {
  return std::generic_category().message(error);
}

// ffmpeg reads frames from `input`, in a process group of its own: Ctrl+C is ours, and ends the film properly.
int start(std::vector<std::string> arguments, int input, int words, pid_t& process) {
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, words, STDERR_FILENO);
  posix_spawn_file_actions_adddup2(&actions, words, STDOUT_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  const int error = posix_spawnp(&process, argv[0], &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

// A file that cannot be written is refused now, in the system's words, not by ffmpeg at the end.
void try_to_write(const std::filesystem::path& file) {
  std::error_code ignored;
  const bool there = std::filesystem::exists(file, ignored);
  OutputFile(file, OutputFile::Mode::append).close();
  if (!there) std::filesystem::remove(file, ignored);
}

}  // namespace

bool ffmpeg_present() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((folder + "/ffmpeg").c_str(), X_OK) == 0) return true;
  return false;
}

Film::Film(const std::filesystem::path& file, ViewSize size, double frames_per_second)
    : file_(file), words_(std::tmpfile()) {
  try_to_write(file_);
  if (!words_) throw FileError("no temporary file for ffmpeg: " + reason(errno));
  int ends[2];
  if (::pipe(ends) != 0) throw FileError("no pipe to ffmpeg: " + reason(errno));
  // ffmpeg inherits only what it reads from: else it would never see the end of the film.
  for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
  std::signal(SIGPIPE, SIG_IGN);  // an ffmpeg that gave up shows as a failed write
  const std::string frame = std::to_string(size.width) + "x" + std::to_string(size.height);
  const int error = start({"ffmpeg",      "-y",       "-loglevel",     "error",
                           "-f",          "rawvideo", "-pixel_format", "rgba",
                           "-video_size", frame,      "-framerate",    std::to_string(frames_per_second),
                           "-i",          "-",        "-vf",           "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                           "-pix_fmt",    "yuv420p",  "-movflags",     "+faststart",
                           file_.string()},
                          ends[0], ::fileno(words_.get()), process_);
  ::close(ends[0]);
  pipe_ = ends[1];
  if (error == 0) return;
  ::close(pipe_);
  process_ = -1;
  if (error == ENOENT)
    throw InputError("", {{"--video", "no ffmpeg on this machine", "an installed ffmpeg; or --images without it"}});
  throw FileError("ffmpeg cannot be started: " + reason(error));
}

Film::~Film() {
  try {
    close();
  } catch (const FileError&) {  // whoever wants to know calls close()
  }
}

void Film::refuse(const std::string& what) const {
  std::rewind(words_.get());
  std::array<char, 400> text{};
  std::string said(text.data(), std::fread(text.data(), 1, text.size(), words_.get()));
  while (!said.empty() && said.back() <= ' ') said.pop_back();
  for (char& c : said)
    if (c == '\n') c = ' ';
  throw FileError(file_.string() + ": " + what + (said.empty() ? "" : ": " + said));
}

void Film::add(const Image& image) {
  const std::uint8_t* at = image.pixels.data();
  std::size_t left = image.pixels.size();
  while (left > 0) {
    const ssize_t written = ::write(pipe_, at, left);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0 && errno == EPIPE) {
      close();  // which says why
      refuse("ffmpeg ended before the film did");
    }
    if (written < 0) throw FileError(file_.string() + ": ffmpeg could not go on: " + reason(errno));
    at += written;
    left -= static_cast<std::size_t>(written);
  }
}

void Film::close() {
  if (process_ < 0) return;
  ::close(pipe_);
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) refuse("ffmpeg could not write this film");
}

}  // namespace pf::app
