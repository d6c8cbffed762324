// What a law costs. `test_materials -ts=timing` prints the table of docs/performance.md.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <limits>

#include "tests/materials/cases.hpp"

using namespace pf;

namespace {

constexpr std::size_t count = 2048;

/// The shortest of many runs, in ns a particle: interruptions only ever add.
double nanoseconds(const std::function<void()>& run) {
  double best = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < 40; ++repeat) {
    const auto start = std::chrono::steady_clock::now();
    run();
    best = std::min(best, std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
  }
  return best / static_cast<double>(count);
}

template <int D>
struct Arrays {
  static constexpr std::size_t lanes = D == 2 ? 4 : 8;
  std::vector<Mat<D>> F, P = std::vector<Mat<D>>(count);
  std::vector<double> psi = std::vector<double>(count), weight = std::vector<double>(count, 1e-3);
  std::vector<Tangent<D>> dP = std::vector<Tangent<D>>(count);
  std::vector<float> matrix = std::vector<float>(count * tangent_components<D>);
  std::vector<float*> place;

  Arrays() {
    for (unsigned p = 0; p < count; ++p) {
      F.push_back(Mat<D>::Identity() + 0.3 * test::random_matrix<D>(p));
      place.push_back(matrix.data() + p / lanes * lanes * tangent_components<D> + p % lanes);
    }
  }
};

template <int D>
void measure(const LawInfo& info) {
  const auto law = make_law<D>(info.name, test::typical_parameters(info));
  Arrays<D> a;
  const double energy = nanoseconds([&] { law->energy(a.F, a.psi); });
  const double stress = nanoseconds([&] { law->stress(a.F, a.psi, a.P); });
  const double tangent = nanoseconds([&] { law->tangent(a.F, false, a.dP); });
  const double projected = nanoseconds([&] { law->tangent(a.F, true, a.dP); });
  const auto grid = [&](bool project) {
    return nanoseconds(
        [&, project] { law->grid_tangent(a.F, a.F, a.weight, project, a.place, static_cast<int>(Arrays<D>::lanes)); });
  };
  std::printf("| `%s` %dD | %.0f | %.0f | %.0f | %.0f | %.0f | %.0f |\n", std::string(info.name).c_str(), D, energy,
              stress, tangent, projected, grid(false), grid(true));
  const double alone = nanoseconds([&] {
    for (std::size_t p = 0; p < count; ++p) law->stress({&a.F[p], 1}, {&a.psi[p], 1}, {&a.P[p], 1});
  });
  CHECK(stress < 0.7 * alone);  // eight at a time
}

}  // namespace

TEST_SUITE("timing") {
  TEST_CASE("a batch costs less a particle than one particle at a time") {
    std::printf("| ns a particle | psi | psi, P | dP | dP projected | for the grid | for the grid, projected |\n");
    for (const LawInfo& info : laws()) {
      measure<2>(info);
      measure<3>(info);
    }
  }
}
