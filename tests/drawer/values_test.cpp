// The values that a study gives to a setting: proposed, typed, extended.
#include "app/studies/values.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "app/preferences.hpp"
#include "app/studies/library.hpp"

using namespace pf;
using namespace pf::app;
using nlohmann::json;

TEST_CASE("a ladder is even in the logarithm and keeps its ends") {
  const std::vector<double> l = ladder(1e-3, 10, 5, true);
  REQUIRE(l.size() == 5);
  CHECK(l.front() == 1e-3);
  CHECK(l.back() == 10);
  for (std::size_t k = 1; k < l.size(); ++k) CHECK(l[k] / l[k - 1] == doctest::Approx(10).epsilon(0.01));
  CHECK(ladder(0, 1, 3, false) == std::vector<double>{0, 0.5, 1});
}

TEST_CASE("typed values take units, refuse what the setting cannot be, and keep all digits of what was there") {
  const Setting& step = *find_setting("/time/step");
  const std::vector<json> before{1.0 / 60, 1.0 / 120};
  std::string refusal;
  const std::string text = values_text(before, step);
  CHECK(typed_values(text + ", 2 ms", step, before, refusal) == std::vector<json>{1.0 / 60, 1.0 / 120, 2e-3});
  CHECK(refusal == "");
  CHECK(typed_values("4 ms; 2e-3,2 ms", step, before, refusal) == std::vector<json>{4e-3, 2e-3});
  CHECK(typed_values("4 ms, -1", step, before, refusal) == before);
  CHECK(refusal.find("not allowed") != std::string::npos);
  CHECK(typed_values("fast", step, before, refusal) == before);
  CHECK_FALSE(refusal.empty());
  CHECK(typed_values(" , ", step, before, refusal) == before);
  CHECK_FALSE(refusal.empty());
}

TEST_CASE("one value more goes on in the ladder's own ratio, within the setting's range") {
  const Setting& step = *find_setting("/time/step");
  CHECK(extended({0.008, 0.004}, step, true) == std::vector<json>{0.008, 0.004, 0.002});
  CHECK(extended({0.008, 0.004}, step, false) == std::vector<json>{0.016, 0.008, 0.004});
  CHECK(extended({0.004}, step, true).size() == 2);
  const Setting& ratio = *find_setting("/transfer/flip_ratio");
  CHECK(extended({0.5, 1.0}, ratio, false) == std::vector<json>{0.5, 1.0});
  const Setting& count = *find_setting("/bodies/0/particles_per_axis");
  CHECK(extended({2, 3}, count, false) == std::vector<json>{2, 3, 4});
}

TEST_CASE("every setting has values to propose, each within its range") {
  for (const Setting& setting : settings()) {
    const bool number = setting.kind == SettingKind::number || setting.kind == SettingKind::integer;
    if (!number && setting.kind != SettingKind::choice && setting.kind != SettingKind::flag) continue;
    CAPTURE(setting.pointer);
    const double now =
        number ? std::clamp(0.5 * (setting.slider_min + setting.slider_max), setting.min, setting.max) : 0;
    for (const json& value : proposed_values(setting, number ? json(now) : json("x"))) {
      if (number) CHECK((value.get<double>() >= setting.min && value.get<double>() <= setting.max));
      if (setting.kind == SettingKind::choice)
        CHECK(std::find(setting.choices.begin(), setting.choices.end(), value) != setting.choices.end());
    }
  }
}

TEST_CASE("names of studies make names of files") {
  CHECK(file_stem("Speed against accuracy, Two blocks", "study") == "speed-against-accuracy-two-blocks");
  CHECK(file_stem("…", "study") == "study");
}
