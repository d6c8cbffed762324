#include "core/energies/volume_patches.hpp"

#include <Eigen/LU>
#include <cmath>

#include "core/grid/stencil.hpp"

namespace pf {

template <int D>
bool share_volume(std::span<const double> volume, std::span<const double> J, double* share, double* stretch) {
  double before = 0, after = 0;
  for (std::size_t k = 0; k < J.size(); ++k) {
    if (!(J[k] > 0)) return false;
    share[k] = volume[k] * J[k];
    before += volume[k];
    after += share[k];
  }
  for (std::size_t k = 0; k < J.size(); ++k) {
    share[k] /= after;
    const double ratio = after / (before * J[k]);
    stretch[k] = D == 2 ? std::sqrt(ratio) : std::cbrt(ratio);
  }
  return true;
}

template <int D>
std::pair<double, double> share_volumes(const Plan<D>& plan, const Particles<D>& particles, const Laws<D>& laws,
                                        Parallel& parallel, const Motion<D>& to) {
  const auto place = [&](std::int32_t p) {
    return static_cast<std::size_t>(to.place ? static_cast<std::int32_t>(to.place[p]) : p);
  };
  for_each_block(plan, parallel, [&](const Block<D>& block, int) {
    std::vector<double> volume, J, share, stretch;
    for_each_patch(plan, particles, laws, block, [&](const VolumePatch& patch) {
      const auto n = static_cast<std::size_t>(patch.end - patch.begin);
      volume.resize(n), J.resize(n), share.resize(n), stretch.resize(n);
      for (std::size_t k = 0; k < n; ++k) {
        const auto p = static_cast<std::size_t>(patch.begin) + k;
        const double J_n = particles.F[p].determinant();
        volume[k] = particles.volume0[p] * J_n;
        J[k] = to.F[place(patch.begin + static_cast<std::int32_t>(k))].determinant() / J_n;
      }
      if (!share_volume<D>(volume, J, share.data(), stretch.data())) return;
      for (std::size_t k = 0; k < n; ++k) to.F[place(patch.begin + static_cast<std::int32_t>(k))] *= stretch[k];
    });
  });
  double least = INFINITY, most = -INFINITY;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const double J = to.F[p].determinant();
    least = std::min(least, J);
    most = std::max(most, J);
  }
  return {least, most};
}

template bool share_volume<2>(std::span<const double>, std::span<const double>, double*, double*);
template bool share_volume<3>(std::span<const double>, std::span<const double>, double*, double*);
template std::pair<double, double> share_volumes<2>(const Plan<2>&, const Particles<2>&, const Laws<2>&, Parallel&,
                                                    const Motion<2>&);
template std::pair<double, double> share_volumes<3>(const Plan<3>&, const Particles<3>&, const Laws<3>&, Parallel&,
                                                    const Motion<3>&);

}  // namespace pf
