// Transfer: how velocity goes from the grid back to the particles, and what that costs in energy and spin.
#include <algorithm>
#include <array>

#include "app/panels/panels.hpp"
#include "app/widgets/setting_widget.hpp"
#include "app/widgets/text.hpp"

namespace pf::app {

namespace {

struct Effect {
  std::string_view type, text;
};
constexpr std::array effects{
    Effect{"pic",
           "Particles take the grid's velocity. Energy: strongly damped, more with shorter steps. Angular "
           "momentum: lost at every transfer."},
    Effect{"flip",
           "Particles add the change of the grid's velocity. Energy: kept up to the share of PIC in the blend. "
           "Angular momentum: almost kept. Noise smaller than a cell stays."},
    Effect{"apic",
           "Particles carry a small velocity field of their own. Energy: slightly damped. Angular momentum: "
           "kept exactly by the transfer."},
    Effect{"fmpm", "PIC corrected order by order. Energy: hardly damped. Angular momentum: nearly kept."},
};

}  // namespace

void draw_transfer_panel(AppContext& context) {
  setting_widget(context, "/transfer/type", {.label = "From grid to particles"});
  const std::string type = context.scene.transfer.type;
  const auto effect = std::find_if(effects.begin(), effects.end(), [&](const Effect& e) { return e.type == type; });
  if (effect != effects.end()) {
    muted(effect->text);
    gap(0.75F);
  }
  setting_widget(context, "/transfer/flip_ratio");
  setting_widget(context, "/transfer/order");
  setting_widget(context, "/transfer/velocity_mass");
}

}  // namespace pf::app
