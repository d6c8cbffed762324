#include <array>
#include <stdexcept>
#include <string>

#include "core/transfers/apic.hpp"
#include "core/transfers/flip.hpp"
#include "core/transfers/fmpm.hpp"

namespace pf {

namespace {
constexpr std::array<TransferInfo, 4> registry{{
    {"pic", "PIC", "Velocity from the grid alone: damps motion and rotation; a smaller dt makes it worse."},
    {"flip", "FLIP and blend",
     "Particles keep their velocity and add the grid's change; a little PIC calms the noise."},
    {"apic", "APIC", "Affine velocities: angular momentum is kept and noise stays low. Jiang et al. 2015."},
    {"fmpm", "FMPM", "PIC whose smoothing is taken back, the more the higher its order. Nairn and Hammerquist 2021."},
}};
}  // namespace

std::span<const TransferInfo> transfers() {
  return registry;
}

template <int D>
std::unique_ptr<Transfer<D>> make_transfer(std::string_view name, double flip_ratio, int order) {
  if (name == "pic") return std::make_unique<FlipTransfer<D>>(0);
  if (name == "flip") return std::make_unique<FlipTransfer<D>>(flip_ratio);
  if (name == "apic") return std::make_unique<ApicTransfer<D>>();
  if (name == "fmpm") return std::make_unique<FmpmTransfer<D>>(order);
  throw std::invalid_argument("unknown transfer " + std::string(name));
}

template std::unique_ptr<Transfer<2>> make_transfer<2>(std::string_view, double, int);
template std::unique_ptr<Transfer<3>> make_transfer<3>(std::string_view, double, int);

}  // namespace pf
