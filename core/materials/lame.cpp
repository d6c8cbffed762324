#include "core/materials/lame.hpp"

namespace pf {

std::vector<LawParameter> isotropic_parameters() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {{.key = "young",
           .label = "Young's modulus",
           .unit = "Pa",
           .min = 0,
           .max = infinity,
           .open_min = true,
           .open_max = true,
           .typical = 1e5,
           .help = "Stiffness: stress per strain of a bar that is pulled. Gelatine 1e4, rubber 1e6, bone 1e10."},
          {.key = "poisson",
           .label = "Poisson's ratio",
           .unit = "",
           .min = -1,
           .max = 0.5,
           .open_min = true,
           .open_max = true,
           .typical = 0.3,
           .help = "How much a bar that is pulled thins. Cork 0, steel 0.3; towards 0.5 the volume is kept, and "
                   "low-order methods get too stiff (locking)."}};
}

}  // namespace pf
