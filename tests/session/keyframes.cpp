// States to go back to: always within the budget, never far from any step.
#include "core/keyframes.hpp"

#include <doctest/doctest.h>

using namespace pf;

namespace {

Keyframe of(long step, std::size_t bytes) {
  return {.step = step, .state = std::string(bytes, 'x')};
}

void run_to(Keyframes& kept, long from, long last, std::size_t bytes) {
  for (long step = from; step <= last; ++step)
    if (kept.wants(step)) kept.add(of(step, bytes));
}

}  // namespace

TEST_CASE("keyframes stay within their memory and leave no gap longer than the interval, however long the run") {
  for (const std::size_t budget : {1000u, 5500u, 100000u}) {
    Keyframes kept(budget);
    for (long last = 0; last < 20000; ++last) {
      run_to(kept, last, last, 1000);
      REQUIRE(kept.bytes() <= budget);
      REQUIRE(kept.bytes() == 1000 * kept.all().size());
      REQUIRE(kept.all().size() <= Keyframes::most);
      const Keyframe* nearest = kept.before(last + 1);
      REQUIRE(nearest);
      // Where only one has room it is thinned away by the next.
      if (budget > 1000) REQUIRE(last + 1 - nearest->step <= 2 * kept.interval());
    }
    if (budget > 1000) {
      CHECK(kept.all().front().step == 0);
      for (std::size_t k = 1; k < kept.all().size(); ++k)
        CHECK(kept.all()[k].step - kept.all()[k - 1].step == kept.interval());
    }
    if (budget == 100000) CHECK(kept.all().size() >= 40);  // most of the memory is used
  }
}

TEST_CASE("the nearest keyframe before a step") {
  Keyframes kept;
  CHECK_FALSE(kept.before(0));
  run_to(kept, 0, 100, 10);
  CHECK(kept.before(0)->step == 0);
  CHECK(kept.before(1)->step == 0);
  CHECK(kept.before(4)->step == 0);
  CHECK(kept.before(5)->step == 4);
  CHECK(kept.before(1000)->step == 100);
  kept.forget_after(50);
  CHECK(kept.before(1000)->step == 48);
  CHECK(kept.bytes() == 10 * kept.all().size());
  run_to(kept, 51, 60, 10);
  CHECK(kept.before(1000)->step == 60);
}

TEST_CASE("less memory gives up keyframes, none keeps none") {
  Keyframes kept;
  run_to(kept, 0, 400, 100);
  kept.set_budget(1000);
  CHECK(kept.bytes() <= 1000);
  CHECK(kept.all().size() >= 4);
  CHECK(kept.before(400));
  kept.set_budget(0);
  CHECK(kept.all().empty());
  CHECK_FALSE(kept.wants(512));
  Keyframes small(50);
  run_to(small, 0, 100, 100);  // none fits
  CHECK(small.bytes() == 0);
}
