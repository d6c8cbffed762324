// pushforward bench: every basis and solver of the registries is measured, in both dimensions.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "core/bases/basis.hpp"
#include "core/solvers/linear_solver.hpp"
#include "program.hpp"

using namespace pf::test;

TEST_CASE("bench measures every basis in 2D and 3D, every preconditioner, explicit and implicit steps") {
  const Workplace place;
  const Outcome done = place.run("bench --quick --particles 1000 --json bench.json");
  INFO(done.err);
  REQUIRE(done.status == 0);
  const auto json = nlohmann::json::parse(pf::read_file(place / "bench.json"));
  CHECK(json["machine"]["fma_one_thread_flop_s"] > 1e9);
  CHECK(json["machine"]["triad"].back()["one_thread_B_s"] > 1e8);
  CHECK(json["kernels"].size() == 2 * pf::bases().size());
  CHECK(json["steps"].size() == 4 * pf::bases().size());
  for (const auto& body : json["kernels"]) {
    std::set<std::string> names;
    for (const auto& kernel : body["kernels"]) {
      CAPTURE(kernel["name"]);
      CHECK(kernel["ns_per_particle"] > 0);
      CHECK(kernel["ns_per_particle"] >= kernel["least_ns_per_particle"]);
      names.insert(kernel["name"]);
    }
    for (const pf::LinearSolverInfo& solver : pf::linear_solvers())
      if (solver.name.starts_with("pcg_"))
        CHECK(names.contains("preconditioner of " + std::string(solver.name) + ", applied"));
  }
  for (const auto& step : json["steps"]) {
    CHECK(step["ns_per_particle"] > 0);
    CHECK((step["name"] == "implicit step") == (step["newton_per_step"] > 0));
  }
}

TEST_CASE("bench refuses what it does not know") {
  const Workplace place;
  CHECK(place.run("bench --basis quartic").status == 2);
  CHECK(place.run("bench --particles 3").status == 2);
  CHECK(place.run("bench --quick --particles 1000 --dimension 2 --basis linear --json /nowhere/x.json").status == 4);
}
