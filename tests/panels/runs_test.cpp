#include "app/panels/runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "app/panels/relevance.hpp"
#include "core/scene/scene_io.hpp"
#include "tests/panels/harness.hpp"

using namespace pf;
using namespace pf::app;

TEST_CASE("runs are told apart by the settings in which they differ") {
  const Scene flip = rich_scene();
  const Scene pic = edited(flip, std::vector<Edit>{{"/transfer/type", "pic"}, {"/time/step", 0.005}});
  const auto a = to_json(flip), b = to_json(pic);
  const std::vector<const nlohmann::ordered_json*> two{&a, &b}, same{&a, &a};
  const auto labels = distinguishing_labels(two);
  CHECK(labels[0].find("FLIP") != std::string::npos);
  CHECK(labels[0].find("10 ms") != std::string::npos);
  CHECK(labels[1].find("PIC") != std::string::npos);
  CHECK(labels[1].find("5 ms") != std::string::npos);
  CHECK(labels[1].find("density") == std::string::npos);
  CHECK(distinguishing_labels(same)[0] == "same settings");
}

TEST_CASE("angular momentum lost is summed by cause from the start of the run") {
  const auto reports = made_up_reports(10);
  Curves curves;
  curves.follow({reports.begin(), reports.begin() + 4});
  curves.follow(reports);
  REQUIRE(curves.size() == 11);
  double transfer = 0, time = 0, torque = 0;
  for (const StepReport& r : reports) {
    transfer += r.angular.transfer.z();
    time += r.angular.time_integration.z();
    torque += r.angular.outside.z();
  }
  CHECK(curves.lost_transfer[2].back() == doctest::Approx(transfer));
  CHECK(curves.lost_time[2].back() == doctest::Approx(time));
  CHECK(curves.outside[2].back() == doctest::Approx(torque));
  CHECK(curves.total[5] == reports[5].balance.total());
  // Another run begins: its curves must not hang on to the old ones.
  curves.follow(made_up_reports(2));
  CHECK(curves.size() == 3);
}

TEST_CASE("thinning a curve keeps its ends and its extremes") {
  std::vector<double> x, y;
  for (int k = 0; k < 100000; ++k) {
    x.push_back(k);
    y.push_back(std::sin(0.01 * k));
  }
  y[31234] = 50;
  y[71234] = -70;
  thin(x, y, 1000);
  CHECK(x.size() <= 1000);
  CHECK(x.front() == 0);
  CHECK(x.back() == 99999);
  CHECK(*std::max_element(y.begin(), y.end()) == 50);
  CHECK(*std::min_element(y.begin(), y.end()) == -70);
  CHECK(std::is_sorted(x.begin(), x.end()));
}

TEST_CASE("only settings that can change the run are offered") {
  Scene s = rich_scene();
  CHECK(scene_uses(s, "/transfer/flip_ratio"));
  CHECK(scene_uses(s, "/boundaries/0/friction"));
  CHECK_FALSE(scene_uses(s, "/bodies/0/seed"));
  s.bodies[0].sampling = "jittered";
  CHECK(scene_uses(s, "/bodies/0/seed"));
  CHECK_FALSE(scene_uses(s, "/bodies/1/seed"));
  s.boundaries[0].contact = "stick";
  CHECK_FALSE(scene_uses(s, "/boundaries/0/friction"));
  CHECK_FALSE(scene_uses(s, "/boundaries/7/friction"));
  for (const char* type : {"pic", "apic"}) {
    s.transfer.type = type;
    CHECK_FALSE(scene_uses(s, "/transfer/flip_ratio"));
  }
  CHECK_FALSE(scene_uses(s, "/transfer/velocity_mass"));  // apic
  CHECK(scene_uses(s, "/solver/newton_tolerance"));
  s.integrator.type = "symplectic_euler";
  CHECK_FALSE(scene_uses(s, "/solver/newton_tolerance"));
}
