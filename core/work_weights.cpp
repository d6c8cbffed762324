#include "core/work_weights.hpp"

#include <algorithm>

namespace pf {

namespace {

// Least times of `pushforward bench` on one core of an Intel Xeon (AVX-512, 2.x GHz), one thread, 100 thousand
// particles in 2D and 512 thousand in 3D, neo-Hookean. P2G holds sorting and the plan of weights; FLIP and APIC are
// averaged, and so are true and projected tangents. A whole matrix' assembly is what is left of preparing multigrid
// when its coarse matrices are taken off. A multiply-add of a sparse factorisation is not in the bench: it was fitted
// to runs with the direct solver.
constexpr KernelWeight table[] = {
    {"p2g", &Work::p2g, {53, 64, 83}, {158, 287, 269}},
    {"g2p", &Work::g2p, {11, 13, 29}, {35, 60, 77}},
    {"energy", &Work::energy, {13, 15, 22}, {38, 45, 58}},
    {"gradient", &Work::gradient, {31, 43, 73}, {83, 123, 223}},
    {"tangent", &Work::tangent, {21, 24, 27}, {147, 129, 145}},
    {"hessian_product", &Work::hessian_product, {8, 15, 22}, {55, 76, 121}},
    {"diagonal", &Work::diagonal, {9, 16, 24}, {78, 122, 190}},
    {"assembly", &Work::assembly, {90, 170, 340}, {340, 890, 3000}},
    {"solver_operations", &Work::solver_operations, {0.6, 0.6, 0.6}, {0.6, 0.6, 0.6}},
    {"stencil_operations", &Work::stencil_operations, {0.5, 0.26, 0.22}, {0.23, 0.22, 0.25}},
};
constexpr std::size_t unit = 5, quadratic = 1;  // a Hessian product in 2D

}  // namespace

std::span<const KernelWeight> kernel_weights() {
  return table;
}

std::string_view kernel_weights_note() {
  return "ns a particle visit (a multiply-add for solver_operations and stencil_operations) by dimension and basis "
         "(linear, quadratic, "
         "cubic): "
         "least times of pushforward bench on one core of an Intel Xeon with AVX-512; work is their sum in units of a "
         "2D quadratic Hessian product";
}

Work& operator+=(Work& work, const Work& more) {
  for (const KernelWeight& weight : table) work.*weight.visits += more.*weight.visits;
  return work;
}

double weighted_work(const Work& work, int dimension, int nodes_per_axis) {
  const auto basis = static_cast<std::size_t>(std::clamp(nodes_per_axis - 2, 0, 2));
  double sum = 0;
  for (const KernelWeight& weight : table)
    sum += static_cast<double>(work.*weight.visits) * (dimension == 2 ? weight.two : weight.three)[basis];
  return sum / table[unit].two[quadratic];
}

}  // namespace pf
