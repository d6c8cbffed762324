#include "app/panels/numbers.hpp"

#include <imgui.h>

#include <array>
#include <cmath>
#include <utility>

#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"

namespace pf::app {

namespace {

/// A factor for all entries and the unit with its prefix: one prefix for each entry would be hard to compare.
std::pair<double, std::string> common_unit(double largest, const std::string& unit) {
  const std::array<std::pair<double, const char*>, 3> prefixes{{{1e9, "G"}, {1e6, "M"}, {1e3, "k"}}};
  if (unit == "Pa")
    for (const auto& [scale, prefix] : prefixes)
      if (largest >= scale) return {scale, prefix + unit};
  return {1, unit};
}

}  // namespace

void matrix_table(const char* title, const Mat3& a, int rows, int columns, const std::string& unit) {
  const auto [factor, shown] = common_unit(a.topLeftCorner(rows, columns).cwiseAbs().maxCoeff(), unit);
  heading((shown.empty() ? std::string(title) : title + (" [" + shown + "]")).c_str());
  const float width = ImGui::GetContentRegionAvail().x / static_cast<float>(columns), left = ImGui::GetCursorPosX();
  const auto text = [&, f = factor](int i, int j, int digits) { return quantity(a(i, j) / f, "", digits); };
  int digits = 5;
  for (bool fits = false; !fits && digits > 2;) {
    fits = true;
    --digits;
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < columns; ++j) fits &= ImGui::CalcTextSize(text(i, j, digits).c_str()).x + em(0.4F) <= width;
  }
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const std::string entry = text(i, j, digits);
      if (j > 0) ImGui::SameLine();
      ImGui::SetCursorPosX(left + width * static_cast<float>(j + 1) - ImGui::CalcTextSize(entry.c_str()).x);
      text_unformatted(entry);
    }
}

void vector_row(const char* title, const Vec3& v, int d, const char* unit) {
  Mat3 row = Mat3::Zero();
  row.row(0) = v.transpose();
  matrix_table(title, row, 1, d, unit);
}

std::string vector_text(const Vec3& v, int d, const char* unit, int digits) {
  std::string text = "(";
  // What is rounding beside the rest is none.
  const double rounding = 1e-12 * v.norm();
  for (int a = 0; a < d; ++a) text += (a > 0 ? ", " : "") + quantity(std::abs(v[a]) > rounding ? v[a] : 0, "", digits);
  return text + ")" + (*unit != 0 ? " " : "") + pretty_unit(unit);
}

std::string index_text(const std::array<std::int32_t, 3>& index, int d) {
  std::string text = "(";
  for (std::size_t a = 0; a < static_cast<std::size_t>(d); ++a) text += (a > 0 ? ", " : "") + quantity(index[a], "", 9);
  return text + ")";
}

}  // namespace pf::app
