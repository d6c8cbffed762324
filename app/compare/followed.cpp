#include "app/compare/followed.hpp"

#include <imgui.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>

#include "app/theme.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"
#include "core/charts/theme.hpp"

namespace pf::app {

namespace {

template <int D>
double determinant(const float* F) {
  return static_cast<double>(Eigen::Map<const Eigen::Matrix<float, D, D>>(F).determinant());
}

void right_aligned(const std::string& text) {
  ImGui::TableNextColumn();
  const float left = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
  if (left > 0) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + left);
  text_unformatted(text);
}

}  // namespace

std::vector<std::optional<FollowedParticle>> followed(const ComparisonFrame& frame, std::uint32_t id, Field field) {
  std::vector<std::optional<FollowedParticle>> out;
  for (const LaneFrame& lane : frame.lanes) {
    out.emplace_back();
    if (!lane.snapshot) continue;
    const Snapshot& s = *lane.snapshot;
    const auto at = std::find(s.id.begin(), s.id.end(), id);
    if (at == s.id.end()) continue;
    const auto p = static_cast<std::size_t>(at - s.id.begin()), d = static_cast<std::size_t>(s.dimension);
    FollowedParticle& particle = out.back().emplace();
    for (std::size_t a = 0; a < d; ++a) particle.x[static_cast<Eigen::Index>(a)] = s.x[p * d + a];
    const float* const F = s.F.data() + p * d * d;
    particle.J = d == 2 ? determinant<2>(F) : determinant<3>(F);
    const auto& values = s.field[static_cast<std::size_t>(field)];
    if (!field_info(field).on_nodes && p < values.size()) particle.value = static_cast<double>(values[p]);
    if (out.size() > 1 && out.front()) particle.apart = (particle.x - out.front()->x).norm();
  }
  return out;
}

void draw_followed(AppContext& context, const CompareDesk& desk) {
  if (!desk.frame) return;
  if (!context.selected_particle) return muted("A click on a particle, in any lane, follows it in all of them.");
  const Field field = context.view.field;
  const FieldInfo& info = field_info(field);
  const auto lanes = followed(*desk.frame, *context.selected_particle, field);
  const auto dimension = static_cast<std::size_t>(context.scene.dimension);
  const bool shown = !desk.difference && field != Field::J && !info.on_nodes;
  std::vector<std::string> heads{"x", "y"};
  if (dimension == 3) heads.emplace_back("z");
  if (shown) heads.emplace_back(info.label);
  heads.emplace_back("J");
  heads.emplace_back("From lane 1");
  constexpr auto flags = ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoSavedSettings | ImGuiTableFlags_PadOuterX |
                         ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_ScrollX;
  const float height = ImGui::GetTextLineHeightWithSpacing() * static_cast<float>(lanes.size() + 1) + em(1.6F);
  if (!ImGui::BeginTable("followed", 1 + static_cast<int>(heads.size()), flags, {0, height})) return;
  ImGui::TableSetupColumn("particle");
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextDisabled("Particle %u", *context.selected_particle);
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  for (const std::string& head : heads) right_aligned(head);
  ImGui::PopStyleColor();
  const ChartTheme theme = context.view.theme == Theme::dark ? dark_theme() : light_theme();
  for (std::size_t k = 0; k < lanes.size(); ++k) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const Color c = theme.series[k];
    ImGui::PushFont(bold_font());
    ImGui::TextColored({c.r, c.g, c.b, c.a}, "%zu", k + 1);
    ImGui::PopFont();
    if (!lanes[k]) {
      right_aligned("not there");
      continue;
    }
    const FollowedParticle& p = *lanes[k];
    for (std::size_t a = 0; a < dimension; ++a) right_aligned(quantity(p.x[static_cast<Eigen::Index>(a)], "m", 4));
    if (shown) right_aligned(p.value ? quantity(*p.value, info.unit, 3) : "");
    right_aligned(quantity(p.J, "", 4));
    right_aligned(p.apart ? quantity(*p.apart, "m", 3) : "");
  }
  ImGui::EndTable();
}

}  // namespace pf::app
