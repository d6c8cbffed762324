// Short messages at the window's edge that go away by themselves.
#pragma once

#include <chrono>
#include <deque>
#include <string>

#include "app/layout.hpp"

namespace pf::app {

class Notices {
 public:
  void add(const std::string& text);
  bool any() const { return !notices_.empty(); }
  /// Drops the old ones; true when one was.
  bool expire();
  /// Above the lower edge of `view`.
  void draw(const Rect& view) const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Notice {
    std::string text;
    Clock::time_point until;
  };
  std::deque<Notice> notices_;
};

}  // namespace pf::app
