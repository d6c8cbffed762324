#include "core/math/lanes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

using namespace pf;

namespace {

template <int size>
void check_records() {
  constexpr int width = Lanes<Pack>::count;
  std::vector<double> records(width * size);
  std::iota(records.begin(), records.end(), 1.0);
  Pack packs[size];
  load_records<size>(records.data(), packs);
  for (int lane = 0; lane < width; ++lane)
    for (int k = 0; k < size; ++k) CHECK(packs[k][lane] == records[static_cast<std::size_t>(lane * size + k)]);
  std::vector<double> back(width * size);
  store_records<size>(packs, back.data());
  CHECK(back == records);
}

}  // namespace

TEST_CASE("records become packs and records again, whatever their length") {
  check_records<1>();
  check_records<4>();
  check_records<8>();
  check_records<9>();
  check_records<16>();
  check_records<81>();
}

TEST_CASE("select, absolute value and square root work lane by lane") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Pack x = {-4, -1, -0.0, 0, 1, 4, 9, nan};
  const Pack size = absolute(x), root = square_root(size), chosen = select(x < 0.0, broadcast<Pack>(7), x);
  for (int lane = 0; lane < 7; ++lane) {
    CHECK(size[lane] == std::abs(x[lane]));
    CHECK(root[lane] == std::sqrt(std::abs(x[lane])));
    CHECK(chosen[lane] == (x[lane] < 0 ? 7 : x[lane]));
  }
  CHECK(std::isnan(chosen[7]));
  CHECK(any(x < 0.0));
  CHECK(!any(x < -5.0));
}
