#include "app/widgets/formula_text.hpp"

#include <imgui.h>

#include <algorithm>

#include "app/formula/formula.hpp"
#include "app/imgui_painter.hpp"
#include "app/widgets/text.hpp"

namespace pf::app {

void formula_text(std::string_view tex, float scale) {
  Formula formula;
  try {
    formula = Formula::parse(tex);
  } catch (const FormulaError&) {
    paragraph(tex);
    return;
  }
  ImGuiPainter painter(*ImGui::GetWindowDrawList());
  const float width = ImGui::GetContentRegionAvail().x;
  float size = em(scale);
  FormulaSize s = formula.measure(painter, size);
  if (s.width > width) {
    size = std::max(em(0.62F), size * width / s.width);
    s = formula.measure(painter, size);
  }
  const float above = em(0.25F), below = em(0.3F);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec4 c = ImGui::GetStyleColorVec4(ImGuiCol_Text);
  formula.draw(painter, {at.x, at.y + above + s.ascent}, size, {c.x, c.y, c.z, c.w});
  ImGui::Dummy(ImVec2(std::min(s.width, width), above + s.ascent + s.descent + below));
}

}  // namespace pf::app
