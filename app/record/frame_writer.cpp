#include "app/record/frame_writer.hpp"

#include <algorithm>
#include <exception>
#include <memory>
#include <utility>

#include "app/record/film.hpp"
#include "core/files.hpp"
#include "core/params/problem.hpp"

namespace pf::app {

namespace {
constexpr std::size_t most_waiting = 4;
}

FrameWriter::FrameWriter(Target target) : target_(std::move(target)) {
  make_folder(target_.film ? std::filesystem::absolute(target_.path).parent_path() : target_.path);
  thread_ = std::jthread([this] { work(); });
}

FrameWriter::~FrameWriter() {
  finish();
}

bool FrameWriter::room() const {
  const std::lock_guard lock(mutex_);
  return waiting_.size() < most_waiting;
}

void FrameWriter::add(Image image, ImageText text) {
  {
    const std::lock_guard lock(mutex_);
    if (!progress_.trouble.empty()) return;
    waiting_.push_back({std::move(image), std::move(text)});
  }
  came_.notify_one();
}

void FrameWriter::finish() {
  {
    const std::lock_guard lock(mutex_);
    finish_ = true;
  }
  came_.notify_one();
}

FrameWriter::Progress FrameWriter::progress() const {
  const std::lock_guard lock(mutex_);
  return progress_;
}

void FrameWriter::work() {
  std::string trouble;
  try {
    std::unique_ptr<Film> film;
    int width = 0, height = 0;
    for (;;) {
      Frame frame;
      long number = 0;
      {
        std::unique_lock lock(mutex_);
        came_.wait(lock, [this] { return finish_ || !waiting_.empty(); });
        if (waiting_.empty()) break;
        frame = std::move(waiting_.front());
        number = progress_.frames;
      }
      if (target_.film) {
        if (!film) {
          width = frame.image.width, height = frame.image.height;
          film = std::make_unique<Film>(target_.path, ViewSize{width, height}, target_.frames_per_second);
        }
        film->add(framed(frame.image, width, height));
      } else {
        write_png(frame.image, target_.path / (file_number(number) + ".png"), frame.text);
      }
      {
        const std::lock_guard lock(mutex_);
        waiting_.pop_front();  // only now: it counts as room
        ++progress_.frames;
      }
      if (target_.wake) target_.wake();
    }
    if (film) film->close();
  } catch (const InputError& error) {
    trouble = error.problems().empty() ? error.what() : error.problems().front().found;
  } catch (const std::exception& error) {
    trouble = error.what();
  }
  {
    const std::lock_guard lock(mutex_);
    progress_.trouble = trouble;
    progress_.done = true;
    waiting_.clear();
  }
  if (target_.wake) target_.wake();
}

Image framed(const Image& image, int width, int height) {
  if (image.width == width && image.height == height) return image;
  Image out(width, height, image.color(0, 0));
  const int w = std::min(width, image.width), h = std::min(height, image.height);
  const int x_in = (image.width - w) / 2, y_in = (image.height - h) / 2;
  const int x_out = (width - w) / 2, y_out = (height - h) / 2;
  for (int y = 0; y < h; ++y)
    std::copy_n(image.at(x_in, y_in + y), 4 * static_cast<std::size_t>(w), out.at(x_out, y_out + y));
  return out;
}

}  // namespace pf::app
