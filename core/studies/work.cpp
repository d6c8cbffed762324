#include "core/studies/work.hpp"

#include <algorithm>

namespace pf {

namespace {

// Least times of `pushforward bench` on one core of an Intel Xeon (AVX-512, 2.x GHz), one thread, 100 thousand
// particles in 2D and 512 thousand in 3D, neo-Hookean. P2G holds sorting and the plan of weights; FLIP and APIC are
// averaged, and so are true and projected tangents. A multiply-add of a sparse factorisation is not in the bench: it
// was fitted to runs with the direct solver.
constexpr KernelWeight table[] = {
    {"p2g", &StudyRow::p2g, {80, 95, 126}, {209, 258, 293}},
    {"g2p", &StudyRow::g2p, {15, 23, 29}, {48, 67, 85}},
    {"energy", &StudyRow::energy, {16, 18, 21}, {41, 48, 57}},
    {"gradient", &StudyRow::gradient, {40, 56, 71}, {93, 129, 190}},
    {"tangent", &StudyRow::tangent, {26, 26, 26}, {150, 130, 125}},
    {"hessian_product", &StudyRow::hessian_product, {13, 18, 22}, {111, 94, 118}},
    {"diagonal", &StudyRow::diagonal, {13, 27, 36}, {216, 311, 588}},
    {"assembly", &StudyRow::assembly, {13, 27, 36}, {216, 311, 588}},
    {"solver_operations", &StudyRow::solver_operations, {0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}},
    {"stencil_operations", &StudyRow::stencil_operations, {0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}},
};
constexpr std::size_t unit = 5, quadratic = 1;  // a Hessian product in 2D

}  // namespace

std::span<const KernelWeight> kernel_weights() {
  return table;
}

std::string_view kernel_weights_note() {
  return "ns a particle visit (a multiply-add for solver_operations) by dimension and basis (linear, quadratic, "
         "cubic): "
         "least times of pushforward bench on one core of an Intel Xeon with AVX-512; work is their sum in units of a "
         "2D quadratic Hessian product";
}

double weighted_work(const StudyRow& row, int dimension, int nodes_per_axis) {
  const auto basis = static_cast<std::size_t>(std::clamp(nodes_per_axis - 2, 0, 2));
  double sum = 0;
  for (const KernelWeight& weight : table)
    sum += row.*weight.visits * (dimension == 2 ? weight.two : weight.three)[basis];
  return sum / table[unit].two[quadratic];
}

}  // namespace pf
