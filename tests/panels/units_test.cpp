#include "app/widgets/units.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace pf::app;

TEST_CASE("quantities are written with sensible digits and SI prefixes") {
  CHECK(quantity(1e5, "Pa") == "100 kPa");
  CHECK(quantity(7e10, "Pa") == "70 GPa");
  CHECK(quantity(0.01, "s") == "10 ms");
  CHECK(quantity(0.5, "s") == "0.5 s");
  CHECK(quantity(1.0 / 60, "s") == "16.67 ms");
  CHECK(quantity(2.5e-5, "m") == "25 \xc2\xb5m");
  CHECK(quantity(-9.81, "m/s^2") ==
        "\xe2\x88\x92"
        "9.81 m/s\xc2\xb2");
  CHECK(quantity(1000, "kg/m^3") == "1000 kg/m\xc2\xb3");
  CHECK(quantity(12345.6, "J/m\xc2\xb3") == "12.35 kJ/m\xc2\xb3");
  CHECK(quantity(0, "Pa") == "0 Pa");
  CHECK(quantity(1e-6, "") == "10⁻⁶");
  CHECK(quantity(-4.5e-7, "") == "−4.5×10⁻⁷");
  CHECK(quantity(2.18e6, "kg/m^3") == "2.18×10⁶ kg/m³");
  CHECK(quantity(0.95, "") == "0.95");
  CHECK(quantity(123456, "") == "123456");
  CHECK(quantity(999999.9, "Pa") == "1 MPa");  // rounding carries into the next prefix
  CHECK(quantity(std::nan(""), "Pa") == "not a number");
  CHECK(quantity(-INFINITY, "Pa") ==
        "\xe2\x88\x92"
        "infinity");
}

TEST_CASE("typed values may carry a prefix, the unit, or be a sum") {
  CHECK(parse_quantity("2.5e4", "Pa") == 2.5e4);
  CHECK(parse_quantity(" 25 kPa ", "Pa") == doctest::Approx(25e3));
  CHECK(parse_quantity("25k", "Pa") == doctest::Approx(25e3));
  CHECK(parse_quantity("10 ms", "s") == doctest::Approx(0.01));
  CHECK(parse_quantity("10 us", "s") == doctest::Approx(1e-5));
  CHECK(parse_quantity("1/60", "s") == doctest::Approx(1.0 / 60));
  CHECK(parse_quantity("-9.81 m/s\xc2\xb2", "m/s^2") == -9.81);
  CHECK(parse_quantity("\xe2\x88\x92"
                       "3",
                       "Pa") == -3.0);                         // a true minus, copied from what is shown
  CHECK(parse_quantity("10⁻⁶", "") == doctest::Approx(1e-6));  // and so a power of ten
  CHECK(parse_quantity("−4.5×10¹² m", "m") == doctest::Approx(-4.5e12));
  CHECK(parse_quantity("5 m", "m") == 5.0);
  CHECK_FALSE(parse_quantity("", "Pa"));
  CHECK_FALSE(parse_quantity("soft", "Pa"));
  CHECK_FALSE(parse_quantity("5 kg", "Pa"));
  CHECK_FALSE(parse_quantity("5 kPa", ""));  // no unit, no prefix
  CHECK_FALSE(parse_quantity("1/0", "s"));
}

TEST_CASE("a number in a text field reads back as the same double") {
  for (const double v : {0.1, 1.0 / 3, 1e-300, 6.02214076e23, -0.0, 123456789.123}) {
    CHECK(std::stod(plain_number(v)) == v);
    CHECK(parse_quantity(plain_number(v), "Pa") == v);
  }
}
