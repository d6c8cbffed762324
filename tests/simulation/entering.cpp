// A body that enters a running simulation: mass, energy and motion are what they should be, and a recording of it
// replays to the byte.
#include <algorithm>

#include "core/runner.hpp"
#include "tests/simulation/scenes.hpp"

using namespace pf;

namespace {

std::vector<Edit> disc(int dimension, const char* name = "disc") {
  return {{"/bodies/-",
           {{"name", name},
            {"material", "rubber"},
            {"velocity", test::point(dimension, 0, -3)},
            {"shape", {{"type", "ball"}, {"center", test::point(dimension, 0.3, 1, 0.3)}, {"radius", 0.2}}}}}};
}

}  // namespace

TEST_CASE("a body enters as it was drawn, and nothing happens to the others") {
  for (const int dimension : {2, 3})
    for (const char* integrator : {"backward_euler", "generalized_alpha", "symplectic_euler"}) {
      CAPTURE(dimension);
      CAPTURE(integrator);
      test::Json scene = test::block(dimension);
      scene["integrator"] = {{"type", integrator}};
      if (std::string(integrator) == "symplectic_euler") scene["time"]["step"] = 0.001;
      scene["bodies"][0]["velocity"] = test::point(dimension, 0.5, 0);
      const auto simulation = test::start(scene);
      test::run(*simulation, 5);
      const auto before = simulation->particles();
      const double mass = simulation->mass();
      const Balance balance = simulation->report().balance;
      REQUIRE(simulation->apply(edited(simulation->scene(), disc(dimension))));
      const auto after = simulation->particles();
      REQUIRE(after.size() > before.size() + 20);
      for (std::size_t p = 0; p < before.size(); ++p) {
        CHECK(after[p].id == before[p].id);
        CHECK(after[p].x == before[p].x);
        CHECK(after[p].v == before[p].v);
        CHECK(after[p].F == before[p].F);
      }
      double entered = 0;
      for (std::size_t p = before.size(); p < after.size(); ++p) {
        entered += after[p].mass;
        CHECK(after[p].id == p);
        CHECK(after[p].body == 1);
        CHECK(after[p].x == after[p].X);
        CHECK(after[p].v == Vec3(0, -3, 0));
      }
      CHECK(simulation->mass() - mass == doctest::Approx(entered));
      const double volume = dimension == 2 ? M_PI * 0.04 : 4.0 / 3 * M_PI * 0.008;
      CHECK(entered == doctest::Approx(1000 * volume));
      CHECK(simulation->report().balance.kinetic - balance.kinetic == doctest::Approx(0.5 * entered * 9));
      test::run(*simulation, 5);
      CHECK(simulation->particles().size() == after.size());
    }
}

TEST_CASE("events bring bodies in: told in the file, resumed from a state, to the same bytes") {
  test::Json scene = test::block();
  scene["gravity"] = {0, -9.81};
  scene["boundaries"] = test::Json::array({test::floor_at(2, 0.1)});
  scene["events"] = test::Json::array({{{"time", 0.05}, {"set", {{"/bodies/-", disc(2)[0].value}}}},
                                       {{"time", 0.09}, {"set", {{"/bodies/-", disc(2, "second")[0].value}}}}});
  const auto whole = test::start(scene), part = test::start(scene);
  Runner(*whole).run({12});
  CHECK(whole->scene().bodies.size() == 3);
  Runner first(*part);
  const RunResult result = first.run({7});
  const std::string state = test::state_of(*part);
  const auto again = test::start(scene);
  EventSchedule(again->scene()).apply_first(*again, result.cursor.events);
  std::istringstream in(state);
  again->load_state(in);
  Runner(*again, result.cursor).run({5});
  CHECK(test::state_of(*again) == test::state_of(*whole));
}

TEST_CASE("a body that cannot be is refused, and the run goes on as if nothing had been") {
  const auto simulation = test::start(test::block()), plain = test::start(test::block());
  test::run(*simulation, 3);
  test::run(*plain, 3);
  std::vector<Edit> thin = disc(2);
  thin[0].value["shape"]["radius"] = 1e-4;  // holds no particle
  thin[0].value["shape"]["center"] = {0.301, 1.0007};
  CHECK_THROWS_AS(simulation->apply(edited(simulation->scene(), thin)), InputError);
  // Fewer bodies, or others, need a reset.
  REQUIRE(simulation->apply(edited(simulation->scene(), disc(2))));
  CHECK_FALSE(simulation->apply(plain->scene()));
}
