// Cutting and painting: who goes, who stays as he was, and that mass, momentum and energy stay accounted for. Events
// replay and resume to the byte.
#include <algorithm>
#include <set>

#include "core/runner.hpp"
#include "tests/simulation/scenes.hpp"

using namespace pf;

namespace {

Shape ball_at(const Vec3& center, double radius) {
  Shape shape;
  shape.type = "ball";
  shape.center = center;
  shape.radius = radius;
  return shape;
}

/// A rubber block beside which steel is known, turning and falling.
test::Json spinning(int dimension) {
  test::Json scene = test::block(dimension, 0.1, 0.7);
  scene["gravity"] = test::point(dimension, 0, -9.81);
  scene["materials"]["steel"] = {{"model", "hencky"}, {"density", 3000}, {"young", 4e5}, {"poisson", 0.2}};
  scene["bodies"][0]["velocity"] =
      dimension == 2 ? test::Json{"-3*(Y-0.4)", "3*(X-0.4)"} : test::Json{"-3*(Y-0.4)", "3*(X-0.4)", "0"};
  return scene;
}

test::Json stroke_json(int dimension, const char* kind, double x, double y) {
  test::Json stroke{{"kind", kind},
                    {"shape", {{"type", "ball"}, {"center", test::point(dimension, x, y, 0.4)}, {"radius", 0.16}}}};
  if (kind == std::string("paint")) stroke["material"] = "steel";
  return stroke;
}

}  // namespace

TEST_CASE("a cut takes the particles within its shape, and what they had is accounted for") {
  for (const int dimension : {2, 3})
    for (const char* integrator : {"backward_euler", "generalized_alpha", "symplectic_euler"}) {
      CAPTURE(dimension);
      CAPTURE(integrator);
      test::Json scene = spinning(dimension);
      scene["integrator"] = {{"type", integrator}};
      if (std::string(integrator) == "symplectic_euler") scene["time"]["step"] = 0.001;
      const auto simulation = test::start(scene);
      simulation->set_ledger(true);
      test::run(*simulation, 4);
      const auto before = simulation->particles();
      const StepReport then = simulation->report();
      const Vec3 centre(0.4, 0.4, dimension == 3 ? 0.4 : 0);
      const double radius = 0.16, mass = simulation->mass();
      std::set<std::uint32_t> gone;
      double gone_mass = 0;
      Vec3 gone_momentum = Vec3::Zero();
      for (const ParticleState& p : before)
        if ((p.x - centre).norm() <= radius) {
          gone.insert(p.id);
          gone_mass += p.mass;
          gone_momentum += p.mass * p.v;
        }
      REQUIRE(gone.size() > 10);
      REQUIRE(simulation->stroke({"cut", ball_at(centre, radius), ""}) == gone.size());
      const auto after = simulation->particles();
      REQUIRE(after.size() == before.size() - gone.size());
      CHECK(simulation->particle_count() == after.size());
      auto q = after.begin();
      bool same = true;
      for (const ParticleState& p : before) {
        if (gone.contains(p.id)) continue;
        same = same && q->id == p.id && q->x == p.x && q->v == p.v && q->F == p.F && q->mass == p.mass;
        ++q;
      }
      CHECK(same);
      CHECK_FALSE(simulation->has_particle(*gone.begin()));
      CHECK(simulation->has_particle(after.back().id));
      const StrokeSums sums = simulation->report().strokes;
      CHECK(sums.count == 1);
      CHECK(sums.cut == gone.size());
      CHECK(sums.mass == doctest::Approx(gone_mass).epsilon(1e-12));
      CHECK(simulation->mass() + sums.mass == doctest::Approx(mass).epsilon(1e-12));
      const double scale = mass * 3;
      CHECK((sums.momentum - gone_momentum).norm() < 1e-12 * scale);
      CHECK((then.balance.momentum - simulation->report().balance.momentum - sums.momentum).norm() < 1e-12 * scale);
      CHECK(then.balance.total() - simulation->report().balance.total() == doctest::Approx(sums.energy).epsilon(1e-12));
      // The step after it: the account closes with a line of its own.
      test::run(*simulation, 1);
      const StepReport& now = simulation->report();
      CHECK(now.energy.strokes == doctest::Approx(-sums.energy).epsilon(1e-12));
      const double change = now.balance.total() - then.balance.total();
      CHECK(std::abs(now.energy.sum() - change) < 1e-11 * std::abs(then.balance.potential));
      const AngularLedger& turns = now.angular;
      const Vec3 turned = now.balance.angular_momentum - then.balance.angular_momentum;
      CHECK((turns.transfer + turns.time_integration + turns.outside + turns.strokes - turned).norm() < 1e-10 * scale);
      test::run(*simulation, 1);
      CHECK(simulation->report().energy.strokes == 0);
      CHECK(simulation->report().strokes.mass == sums.mass);
    }
}

TEST_CASE("paint gives particles another material where they are, deformed as they are") {
  for (const int dimension : {2, 3}) {
    CAPTURE(dimension);
    const auto simulation = test::start(spinning(dimension));
    simulation->set_ledger(true);
    test::run(*simulation, 4);
    const auto before = simulation->particles();
    const StepReport then = simulation->report();
    const double mass = simulation->mass();
    const Vec3 centre(0.4, 0.4, dimension == 3 ? 0.4 : 0);
    const Stroke stroke{"paint", ball_at(centre, 0.16), "steel"};
    const std::size_t count = simulation->stroke(stroke);
    REQUIRE(count > 10);
    CHECK(simulation->stroke(stroke) == 0);  // it is steel already
    const auto after = simulation->particles();
    REQUIRE(after.size() == before.size());
    std::size_t painted = 0;
    double elastic = 0;
    for (std::size_t p = 0; p < after.size(); ++p) {
      CHECK(after[p].F == before[p].F);
      CHECK(after[p].v == before[p].v);
      elastic += after[p].energy_density * after[p].volume0;
      const bool steel = after[p].material == 1;
      CHECK(steel == ((before[p].x - centre).norm() <= 0.16));
      painted += steel ? 1 : 0;
      CHECK(after[p].mass == doctest::Approx((steel ? 3 : 1) * before[p].mass));
    }
    CHECK(painted == count);
    CHECK(simulation->report().balance.elastic == doctest::Approx(elastic));
    const StrokeSums& sums = simulation->report().strokes;
    CHECK(sums.painted == count);
    CHECK(sums.cut == 0);
    CHECK(simulation->mass() + sums.mass == doctest::Approx(mass).epsilon(1e-12));
    test::run(*simulation, 1);
    const StepReport& now = simulation->report();
    CHECK(std::abs(now.energy.sum() - (now.balance.total() - then.balance.total())) <
          1e-11 * std::abs(then.balance.potential));
  }
}

TEST_CASE("what a stroke cannot do it leaves undone, and says why") {
  const auto simulation = test::start(spinning(2));
  test::run(*simulation, 2);
  const std::string state = test::state_of(*simulation);
  CHECK_THROWS_AS(simulation->stroke({"cut", ball_at(Vec3(0.4, 0.4, 0), 5), ""}), InputError);
  CHECK_THROWS_AS(simulation->stroke({"paint", ball_at(Vec3(0.4, 0.4, 0), 5), "glass"}), InputError);
  CHECK(simulation->stroke({"cut", ball_at(Vec3(9, 9, 0), 0.5), ""}) == 0);
  CHECK(test::state_of(*simulation) == state);
  test::Json known = test::block();
  known["exact"] = {{"position", {"X+t", "Y"}}};
  const auto exact = test::start(known);
  CHECK_THROWS_AS(exact->stroke({"cut", ball_at(Vec3(0.4, 0.4, 0), 0.1), ""}), InputError);
}

TEST_CASE("a cut leaves the rest to move as if the gone had never been there") {
  test::Json scene = test::block(2, 0.1, 0.5);
  scene["bodies"].push_back({{"name", "far"}, {"material", "rubber"}, {"shape", test::box({2.1, 0.1}, {2.5, 0.5})}});
  const auto cut = test::start(scene);
  REQUIRE(cut->stroke({"cut", ball_at(Vec3(2.3, 0.3, 0), 0.5), ""}) == 64);
  scene["bodies"].erase(1);
  const auto alone = test::start(scene);
  for (const auto& simulation : {cut.get(), alone.get()}) test::run(*simulation, 5);
  test::check_equal(cut->particles(), alone->particles());
  CHECK(cut->report().balance.kinetic == alone->report().balance.kinetic);
}

TEST_CASE("a probe ends with its particle; a load with the surface that it was on") {
  test::Json scene = test::block(2, 0.1, 0.5);
  scene["probes"] =
      test::Json::array({{{"name", "corner"}, {"at", {0.5, 0.5}}}, {{"name", "foot"}, {"at", {0.1, 0.1}}}});
  scene["loads"] = test::Json::array(
      {{{"body", "block"}, {"region", test::box({0.5, 0.1}, {0.5, 0.5})}, {"traction", {"1000", "0"}}}});
  const auto simulation = test::start(scene);
  test::run(*simulation, 1);
  const double pushed = simulation->report().balance.momentum.x();
  CHECK(pushed == doctest::Approx(0.01 * 1000 * 0.4).epsilon(1e-6));
  REQUIRE(simulation->probes().size() == 2);
  Shape half;
  half.type = "box";
  half.min = Vec3(0.4, 0.29, 0);
  half.max = Vec3(0.6, 0.6, 0);
  REQUIRE(simulation->stroke({"cut", half, ""}) > 0);
  const auto left = simulation->probes();
  REQUIRE(left.size() == 1);
  CHECK(left[0].probe == 1);
  const double before = simulation->report().balance.momentum.x();
  test::run(*simulation, 1);
  // Of the loaded face the part below y = 0.29 is left; its points are dx/8 apart.
  CHECK(simulation->report().balance.momentum.x() - before == doctest::Approx(0.01 * 1000 * 0.19).epsilon(0.05));
}

TEST_CASE("strokes as events: any number of threads, resumed from a state, with a body that comes later") {
  for (const int dimension : {2, 3})
    for (const bool adaptive : {false, true}) {
      CAPTURE(dimension);
      CAPTURE(adaptive);
      test::Json scene = spinning(dimension);
      if (adaptive) scene["time"]["control"] = "adaptive";
      const test::Json disc{
          {"name", "disc"},
          {"material", "rubber"},
          {"shape", {{"type", "ball"}, {"center", test::point(dimension, 1.3, 0.4, 0.4)}, {"radius", 0.15}}}};
      scene["probes"] = test::Json::array({{{"at", test::point(dimension, 0.4, 0.4, 0.4)}}});
      scene["events"] = test::Json::array(
          {{{"time", 0.02}, {"strokes", {stroke_json(dimension, "cut", 0.4, 0.4)}}},
           {{"time", 0.04},
            {"set", {{"/bodies/-", disc}, {"/probes/-", {{"at", test::point(dimension, 0.4, 0.41, 0.4)}}}}}},
           {{"time", 0.06},
            {"strokes", {stroke_json(dimension, "paint", 0.2, 0.2), stroke_json(dimension, "cut", 1.35, 0.4)}}}});
      const auto whole = test::start(scene), four = test::start(scene, 4), part = test::start(scene);
      Runner(*whole).run({14});
      Runner(*four).run({14});
      REQUIRE(whole->time() > 0.06);
      CHECK(whole->report().strokes.count == 3);
      CHECK(whole->report().strokes.cut > 10);
      CHECK(whole->report().strokes.painted > 10);
      // New particles have new ids.
      std::set<std::uint32_t> ids;
      for (const ParticleState& p : whole->particles()) ids.insert(p.id);
      CHECK(ids.size() == whole->particle_count());
      CHECK(*ids.rbegin() >= whole->particle_count());
      CHECK(whole->probes().size() == 1);  // the other one ended with its particle
      CHECK(test::state_of(*four) == test::state_of(*whole));
      for (const long at : {3L, 5L, 8L}) {
        CAPTURE(at);
        const auto first = test::start(scene);
        Runner runner(*first);
        const RunResult result = runner.run({at});
        const std::string state = test::state_of(*first);
        const auto again = test::start(scene);
        EventSchedule(again->scene()).apply_first(*again, result.cursor.events);
        std::istringstream in(state);
        again->load_state(in);
        CHECK(test::state_of(*again) == state);
        CHECK(again->report().strokes.mass == first->report().strokes.mass);
        Runner(*again, result.cursor).run({14 - at});
        CHECK(test::state_of(*again) == test::state_of(*whole));
        CHECK(again->probes().size() == whole->probes().size());
      }
    }
}

TEST_CASE("a state says whose particles it has") {
  const auto simulation = test::start(spinning(2));
  test::run(*simulation, 1);
  std::string state = test::state_of(*simulation);
  REQUIRE(simulation->stroke({"cut", ball_at(Vec3(0.4, 0.4, 0), 0.16), ""}) > 0);
  std::string fewer = test::state_of(*simulation);
  const auto load = [](Simulation& into, const std::string& bytes) {
    std::istringstream in(bytes);
    into.load_state(in);
  };
  // Either way, whatever the simulation has of them now.
  load(*simulation, state);
  CHECK(test::state_of(*simulation) == state);
  load(*simulation, fewer);
  CHECK(test::state_of(*simulation) == fewer);
  test::Json larger = spinning(2);
  larger["bodies"][0]["shape"] = test::box({0.1, 0.1}, {0.8, 0.8});
  CHECK_THROWS_AS(load(*test::start(larger), fewer), InputError);
}
