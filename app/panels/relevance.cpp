#include "app/panels/relevance.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace pf::app {

namespace {

/// Index of the array element that "/bodies/3/seed" is about; -1 when there is none.
int index_in(std::string_view pointer) {
  const std::size_t from = pointer.find('/', 1);
  if (from == std::string_view::npos) return -1;
  int index = -1;
  std::from_chars(pointer.data() + from + 1, pointer.data() + pointer.size(), index);
  return index;
}

template <class T>
const T* element(const std::vector<T>& items, std::string_view pointer) {
  const int i = index_in(pointer);
  return i >= 0 && static_cast<std::size_t>(i) < items.size() ? &items[static_cast<std::size_t>(i)] : nullptr;
}

bool adaptive(const Scene& s) {
  return s.time.control == "adaptive";
}
bool explicit_step(const Scene& s) {
  return s.integrator.type == "symplectic_euler" && !adaptive(s);
}
bool has_inertia(const Scene& s) {
  return s.integrator.type != "quasi_static";
}

bool rubs(const Scene& s, std::string_view pointer) {
  const Boundary* b = element(s.boundaries, pointer);
  return b != nullptr && b->contact == "separate";
}
bool random(const Scene& s, std::string_view pointer) {
  const Body* b = element(s.bodies, pointer);
  return b != nullptr && b->sampling != "lattice";
}

struct Rule {
  std::string_view prefix, suffix;
  bool (*used)(const Scene&, std::string_view pointer);
};
/// The first rule that matches decides; what no rule names is always used.
constexpr std::array rules{
    Rule{"/transfer/flip_ratio", "",
         [](const Scene& s, std::string_view) { return has_inertia(s) && s.transfer.type == "flip"; }},
    Rule{"/transfer/order", "",
         [](const Scene& s, std::string_view) { return has_inertia(s) && s.transfer.type == "fmpm"; }},
    Rule{"/transfer/velocity_mass", "",
         [](const Scene& s, std::string_view) {
           return has_inertia(s) && s.transfer.type != "apic" && s.transfer.type != "fmpm";
         }},
    Rule{"/transfer/", "", [](const Scene& s, std::string_view) { return has_inertia(s); }},
    Rule{"/time/tolerance", "", [](const Scene& s, std::string_view) { return adaptive(s); }},
    Rule{"/integrator/spectral_radius", "",
         [](const Scene& s, std::string_view) { return s.integrator.type == "generalized_alpha"; }},
    Rule{"/integrator/ghost_penalty", "",
         [](const Scene& s, std::string_view) {
           return !has_inertia(s) || s.integrator.mass == "consistent" || s.transfer.velocity_mass == "consistent";
         }},
    Rule{"/integrator/mass", "", [](const Scene& s, std::string_view) { return has_inertia(s) && !explicit_step(s); }},
    Rule{"/solver/", "", [](const Scene& s, std::string_view) { return !explicit_step(s); }},
    Rule{"/boundaries/", "/friction", rubs},
    Rule{"/bodies/", "/seed", random},
    Rule{"/manufactured", "", [](const Scene& s, std::string_view) { return !s.exact_position.empty(); }},
};

}  // namespace

bool scene_uses(const Scene& scene, std::string_view pointer) {
  const auto rule = std::find_if(rules.begin(), rules.end(), [&](const Rule& r) {
    return pointer.starts_with(r.prefix) && pointer.ends_with(r.suffix);
  });
  return rule == rules.end() || rule->used(scene, pointer);
}

}  // namespace pf::app
