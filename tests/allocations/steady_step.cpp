// A steady step takes no memory from the system. This executable counts what is asked of malloc.
#include <doctest/doctest.h>

#include <atomic>
#include <cstdlib>

#include "tests/simulation/scenes.hpp"

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {

std::atomic<bool> counting{false};
std::atomic<int> count{0};

void note() {
  if (counting.load(std::memory_order_relaxed)) count.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace

extern "C" {
// The C library's own, for those who stand in for them. operator new and Eigen come through here too.
void* __libc_malloc(std::size_t);                 // NOLINT
void* __libc_calloc(std::size_t, std::size_t);    // NOLINT
void* __libc_realloc(void*, std::size_t);         // NOLINT
void* __libc_memalign(std::size_t, std::size_t);  // NOLINT

void* malloc(std::size_t bytes) {
  note();
  return __libc_malloc(bytes);
}
void* calloc(std::size_t n, std::size_t bytes) {
  note();
  return __libc_calloc(n, bytes);
}
void* realloc(void* memory, std::size_t bytes) {
  note();
  return __libc_realloc(memory, bytes);
}
void* aligned_alloc(std::size_t alignment, std::size_t bytes) {
  note();
  return __libc_memalign(alignment, bytes);
}
}

using namespace pf;

namespace {

/// Allocations of one step, after some in which everything found its size.
int in_a_steady_step(Simulation& simulation, int before) {
  test::run(simulation, before);
  count = 0;
  counting = true;
  const StepReport& report = simulation.step();
  counting = false;
  REQUIRE(report.status == StepStatus::accepted);
  return count;
}

test::Json resting(int dimension, std::string_view integrator, std::string_view solver) {
  test::Json scene = test::block(dimension, 0.05, 0.45);
  scene["grid"]["spacing"] = dimension == 2 ? 0.05 : 0.1;
  scene["integrator"]["type"] = integrator;
  scene["solver"]["linear"] = solver;
  scene["time"]["step"] = integrator == "backward_euler" ? 1e-3 : 1e-4;
  return scene;
}

}  // namespace

TEST_CASE("the counter counts") {
  count = 0;
  counting = true;
  std::vector<double> numbers(100);
  const Vector vector = Vector::Zero(100);
  counting = false;
  CHECK(count == 2);
  CHECK(numbers.size() + static_cast<std::size_t>(vector.size()) == 200);
}

TEST_CASE("an explicit step allocates nothing") {
  for (const int dimension : {2, 3}) {
    CAPTURE(dimension);
    test::Json scene = resting(dimension, "symplectic_euler", "pcg_jacobi");
    scene["gravity"] = dimension == 2 ? test::Json{0, -9.81} : test::Json{0, -9.81, 0};
    const auto simulation = test::start(scene);
    CHECK(in_a_steady_step(*simulation, 10) == 0);
  }
}

TEST_CASE("an implicit step allocates the list of its Newton iterations, in contact and with a chosen solver too") {
  for (const int dimension : {2, 3})
    for (const auto& [contact, solver] :
         {std::pair(false, "pcg_jacobi"), {true, "pcg_jacobi"}, {false, "auto"}, {false, "pcg_multigrid"}}) {
      CAPTURE(dimension);
      CAPTURE(contact);
      CAPTURE(solver);
      test::Json scene = resting(dimension, "backward_euler", solver);
      scene["gravity"] = dimension == 2 ? test::Json{0, -9.81} : test::Json{0, -9.81, 0};
      if (contact) scene["boundaries"] = test::Json::array({test::floor_at(dimension, 0.049)});
      const auto simulation = test::start(scene);
      CHECK(in_a_steady_step(*simulation, 10) <= 1);
      if (contact) CHECK(simulation->report().linear_iterations > 0);
    }
}

TEST_CASE("a consistent mass allocates no more than a lumped one") {
  for (const int dimension : {2, 3}) {
    CAPTURE(dimension);
    test::Json scene = resting(dimension, "backward_euler", "pcg_jacobi");
    scene["gravity"] = dimension == 2 ? test::Json{0, -9.81} : test::Json{0, -9.81, 0};
    scene["integrator"]["mass"] = "consistent";
    scene["transfer"] = {{"type", "flip"}, {"velocity_mass", "consistent"}};
    CHECK(in_a_steady_step(*test::start(scene), 10) <= 1);
  }
}

#endif
