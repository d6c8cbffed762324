// A lesson played through without a window: values set, conditions waited for, claims and answers checked.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/lessons/lesson.hpp"
#include "core/math/expression.hpp"

namespace pf::app {

struct Rehearsal {
  std::vector<std::string> problems;  ///< empty: everything came out as the lesson says
  Constants kept;
  std::size_t steps = 0;
};
/// `page_done`, if given, is called after each page with what is measured then.
Rehearsal rehearse(const Lesson& lesson, const std::function<void(std::size_t, const Constants&)>& page_done = {});

}  // namespace pf::app
