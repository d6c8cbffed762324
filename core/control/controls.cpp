#include <array>
#include <stdexcept>
#include <string>

#include "core/control/adaptive_control.hpp"
#include "core/control/fixed_control.hpp"

namespace pf {

namespace {
constexpr std::array<StepControlInfo, 2> registry{{
    {"fixed", "Fixed step", "Every step as long as time.step."},
    {"adaptive", "Adaptive",
     "The step follows time.tolerance; explicit or implicit, whichever takes less counted work."},
}};
}  // namespace

std::span<const StepControlInfo> step_controls() {
  return registry;
}

std::unique_ptr<StepControl> make_step_control(std::string_view name, const ControlSetup& setup) {
  if (name == "fixed") return std::make_unique<FixedControl>(setup);
  if (name == "adaptive") return std::make_unique<AdaptiveControl>(setup);
  throw std::invalid_argument("unknown step control " + std::string(name));
}

}  // namespace pf
