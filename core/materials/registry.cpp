// The one table of material laws: a new law is a file of its own and a line here.
#include <stdexcept>

#include "core/materials/batch_law.hpp"
#include "core/materials/fixed_corotated.hpp"
#include "core/materials/hencky.hpp"
#include "core/materials/linear_elastic.hpp"
#include "core/materials/neo_hookean.hpp"
#include "core/materials/st_venant_kirchhoff.hpp"

namespace pf {
namespace {

struct Entry {
  LawInfo info;
  std::unique_ptr<Law<2>> (*make_2d)(std::span<const double>);
  std::unique_ptr<Law<3>> (*make_3d)(std::span<const double>);
};

template <class Model, int D>
std::unique_ptr<Law<D>> make(std::span<const double> parameters) {
  return std::make_unique<BatchLaw<Model, D>>(Model::from(parameters));
}

template <class Model>
Entry entry() {
  return {Model::info(), make<Model, 2>, make<Model, 3>};
}

const std::vector<Entry>& table() {
  static const std::vector<Entry> entries = {
      entry<NeoHookean>(), entry<FixedCorotated>(), entry<Hencky>(), entry<StVenantKirchhoff>(), entry<LinearElastic>(),
  };
  return entries;
}

}  // namespace

std::span<const LawInfo> laws() {
  static const std::vector<LawInfo> infos = [] {
    std::vector<LawInfo> list;
    for (const Entry& entry : table()) list.push_back(entry.info);
    return list;
  }();
  return infos;
}

const LawInfo* find_law(std::string_view name) {
  for (const LawInfo& info : laws())
    if (info.name == name) return &info;
  return nullptr;
}

template <int D>
std::unique_ptr<Law<D>> make_law(std::string_view name, std::span<const double> parameters) {
  for (const Entry& entry : table()) {
    if (entry.info.name != name) continue;
    if (entry.info.parameters.size() != parameters.size())
      throw std::invalid_argument("material law " + std::string(name) + " takes " +
                                  std::to_string(entry.info.parameters.size()) + " parameters");
    if constexpr (D == 2) {
      return entry.make_2d(parameters);
    } else {
      return entry.make_3d(parameters);
    }
  }
  throw std::invalid_argument("no material law is called " + std::string(name));
}

template std::unique_ptr<Law<2>> make_law<2>(std::string_view, std::span<const double>);
template std::unique_ptr<Law<3>> make_law<3>(std::string_view, std::span<const double>);

}  // namespace pf
