#include "core/charts/ticks.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

using pf::TickSet;

namespace {

bool always(const std::vector<pf::Tick>&) {
  return true;
}

std::string labels(const TickSet& set) {
  std::string all;
  for (const pf::Tick& tick : set.major) all += (all.empty() ? "" : " ") + tick.label;
  return all;
}

}  // namespace

TEST_CASE("linear ticks are round, within the range, and say exactly their value") {
  CHECK(labels(pf::linear_ticks(0, 1, 6, always)) == "0 0.2 0.4 0.6 0.8 1.0");
  CHECK(labels(pf::linear_ticks(-1, 1, 5, always)) == "−1.0 −0.5 0 0.5 1.0");
  CHECK(labels(pf::linear_ticks(0.12, 0.31, 5, always)) == "0.15 0.20 0.25 0.30");
  CHECK(labels(pf::linear_ticks(3, 17, 8, always)) == "4 6 8 10 12 14 16");
  CHECK(labels(pf::linear_ticks(1e6, 1e6 + 4, 5, always)) == "1.000000 1.000001 1.000002 1.000003 1.000004");
  const TickSet big = pf::linear_ticks(0, 31500, 7, always);
  CHECK(labels(big) == "0 5 10 15 20 25 30");
  CHECK(big.exponent == 3);
  const TickSet small = pf::linear_ticks(0, 4.6e-3, 5, always);
  CHECK(labels(small) == "0 1 2 3 4");
  CHECK(small.exponent == -3);
}

TEST_CASE("linear ticks over many ranges: sorted, distinct labels, never more than asked, at least two") {
  for (int magnitude = -300; magnitude <= 300; magnitude += 7) {
    for (const double low : {-1.0, 0.0, 0.37, 12.3}) {
      for (const double span : {0.011, 0.3, 1.0, 7.7}) {
        for (const int most : {3, 5, 10}) {
          const double scale = std::pow(10.0, magnitude), min = low * scale, max = (low + span) * scale;
          const TickSet set = pf::linear_ticks(min, max, most, always);
          CAPTURE(min);
          CAPTURE(max);
          CAPTURE(most);
          CHECK(set.major.size() >= 1);
          CHECK(static_cast<int>(set.major.size()) <= most);
          std::set<std::string> distinct;
          for (std::size_t k = 0; k < set.major.size(); ++k) {
            distinct.insert(set.major[k].label);
            CHECK(set.major[k].value >= min - 1e-9 * (max - min));
            CHECK(set.major[k].value <= max + 1e-9 * (max - min));
            if (k > 0) CHECK(set.major[k].value > set.major[k - 1].value);
          }
          CHECK(distinct.size() == set.major.size());
        }
      }
    }
  }
}

TEST_CASE("ticks thin out until their labels fit") {
  const auto three = [](const std::vector<pf::Tick>& ticks) { return ticks.size() <= 3; };
  CHECK(labels(pf::linear_ticks(0, 10, 11, three)) == "0 5 10");
  CHECK(pf::logarithmic_ticks(1e-9, 1e3, 20, three).major.size() <= 3);
  const auto never = [](const std::vector<pf::Tick>& ticks) { return ticks.empty(); };
  CHECK(pf::linear_ticks(0, 10, 11, never).major.empty());
  CHECK(pf::logarithmic_ticks(1, 10, 11, never).major.empty());
}

TEST_CASE("logarithmic ticks stand at powers of ten, minor ones between") {
  const TickSet decades = pf::logarithmic_ticks(2e-5, 3e-1, 10, always);
  CHECK(labels(decades) == "10⁻⁴ 10⁻³ 10⁻² 10⁻¹");
  CHECK(decades.minor.size() == 8 + 3 * 8 + 2);  // 2e-5 ... 9e-5, three whole decades, 2e-1 and 3e-1
  CHECK(labels(pf::logarithmic_ticks(0.5, 200, 10, always)) == "1 10 100");
  CHECK(labels(pf::logarithmic_ticks(1e-12, 1, 5, always)) == "10⁻¹² 10⁻⁹ 10⁻⁶ 10⁻³ 10⁰");
  CHECK(labels(pf::logarithmic_ticks(0.8, 30, 10, always)) == "1 2 5 10 20");
  CHECK(labels(pf::logarithmic_ticks(3e-7, 4e-6, 10, always)) == "5×10⁻⁷ 10⁻⁶ 2×10⁻⁶");
}

TEST_CASE("less than a decade on a logarithmic axis has equal steps and no hidden factor") {
  const TickSet set = pf::logarithmic_ticks(0.00011, 0.00019, 6, always);
  CHECK(set.exponent == 0);
  CHECK(set.major.size() >= 3);
  CHECK(set.major.front().label == "1.20×10⁻⁴");
}

TEST_CASE("logarithmic ticks over many ranges have labels, distinct and within") {
  for (int low = -299; low < 290; low += 13) {
    for (const double decades : {0.01, 0.3, 0.9, 1.1, 2.5, 7.0, 19.0}) {
      for (const int most : {3, 6, 12}) {
        const double min = 3.3 * std::pow(10.0, low), max = min * std::pow(10.0, decades);
        const TickSet set = pf::logarithmic_ticks(min, max, most, always);
        CAPTURE(min);
        CAPTURE(max);
        CHECK(!set.major.empty());
        CHECK(static_cast<int>(set.major.size()) <= most);
        std::set<std::string> distinct;
        for (const pf::Tick& tick : set.major) {
          distinct.insert(tick.label);
          CHECK(tick.value >= min * (1 - 1e-8));
          CHECK(tick.value <= max * (1 + 1e-8));
        }
        CHECK(distinct.size() == set.major.size());
      }
    }
  }
}

TEST_CASE("titles carry the unit with an SI prefix where the unit takes one") {
  CHECK(pf::axis_title("Energy", "J", 3) == "Energy [kJ]");
  CHECK(pf::axis_title("Speed", "m/s", -3) == "Speed [mm/s]");
  CHECK(pf::axis_title("Stress", "Pa", 6) == "Stress [MPa]");
  CHECK(pf::axis_title("Area", "m²", -6) == "Area [10⁻⁶ m²]");
  CHECK(pf::axis_title("Momentum", "kg m/s", 3) == "Momentum [10³ kg m/s]");
  CHECK(pf::axis_title("Error", "", -3) == "Error [10⁻³]");
  CHECK(pf::axis_title("Error", "", 0) == "Error");
  CHECK(pf::axis_title("Time", "s", 0) == "Time [s]");
  CHECK(pf::axis_title("Energy", "J", 30) == "Energy [10³⁰ J]");
}

TEST_CASE("numbers for people") {
  CHECK(pf::number_text(0.0123456) == "0.01235");
  CHECK(pf::number_text(-4.5e-7, 3) == "−4.50×10⁻⁷");
  CHECK(pf::number_text(123456.7) == "123457");
  CHECK(pf::number_text(9.9999e9, 3) == "1.00×10¹⁰");
  CHECK(pf::number_text(0) == "0");
  CHECK(pf::number_text(std::nan("")) == "not a number");
  CHECK(pf::number_text(-INFINITY) == "−∞");
  CHECK(pf::fixed_text(-0.0001, 2) == "0.00");
  CHECK(pf::power_of_ten(-12) == "10⁻¹²");
}
