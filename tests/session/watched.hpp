// A session whose simulation the test may look at while its worker is idle.
#pragma once

#include <doctest/doctest.h>

#include <thread>

#include "app/session.hpp"
#include "core/simulation.hpp"

namespace pf::app {

struct WatchedSession {
  Simulation* simulation = nullptr;
  Session session{1, [this](const Scene& scene, const SimulationOptions& options) {
                    auto made = make_simulation(scene, options);
                    simulation = made.get();
                    return made;
                  }};
  void wait(auto condition) {
    using namespace std::chrono_literals;
    for (int i = 0; i < 300000 && !condition(session.status()); ++i) std::this_thread::sleep_for(100us);
    REQUIRE(condition(session.status()));
  }
  void steps(long count) {
    for (long i = 0; i < count; ++i) {
      const long step = session.status().step;
      session.step_once();
      wait([=](const SessionStatus& s) { return s.step == step + 1 && !s.step_in_flight; });
    }
  }
};

}  // namespace pf::app
