#include "core/studies/work.hpp"

#include <algorithm>

namespace pf {

namespace {

constexpr KernelWeight table[] = {
    {"p2g", &StudyRow::p2g, {60, 80, 110}, {120, 200, 400}},
    {"g2p", &StudyRow::g2p, {60, 80, 110}, {120, 200, 400}},
    {"energy", &StudyRow::energy, {25, 30, 40}, {50, 80, 150}},
    {"gradient", &StudyRow::gradient, {40, 50, 70}, {80, 130, 260}},
    {"tangent", &StudyRow::tangent, {35, 45, 60}, {90, 130, 250}},
    {"hessian_product", &StudyRow::hessian_product, {10, 15, 25}, {40, 70, 160}},
    {"assembly", &StudyRow::assembly, {60, 120, 300}, {400, 1500, 6000}},
    {"factorisation", &StudyRow::factorisation, {0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}},
};
constexpr std::size_t unit = 5, quadratic = 1;

}  // namespace

std::span<const KernelWeight> kernel_weights() {
  return table;
}

std::string_view kernel_weights_note() {
  return "ns a particle visit";
}

double weighted_work(const StudyRow& row, int dimension, int nodes_per_axis) {
  const auto basis = static_cast<std::size_t>(std::clamp(nodes_per_axis - 2, 0, 2));
  double sum = 0;
  for (const KernelWeight& weight : table)
    sum += row.*weight.visits * (dimension == 2 ? weight.two : weight.three)[basis];
  return sum / table[unit].two[quadratic];
}

}  // namespace pf
