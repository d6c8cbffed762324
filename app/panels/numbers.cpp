#include "app/panels/numbers.hpp"

#include <imgui.h>

#include <array>
#include <cmath>
#include <utility>

#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"
#include "core/charts/ticks.hpp"

namespace pf::app {

namespace {

/// A factor for all entries and the unit with its prefix: one prefix for each entry would be hard to compare. Small
/// ones are for numbers that stand still: live ones would change their unit as they pass zero.
std::pair<double, std::string> common_unit(double largest, const std::string& unit, bool small_too) {
  const std::array<std::pair<double, const char*>, 3> large{{{1e9, "G"}, {1e6, "M"}, {1e3, "k"}}};
  const std::array<std::pair<double, const char*>, 3> small{{{1e-9, "n"}, {1e-6, "\xc2\xb5"}, {1e-3, "m"}}};
  if (unit == "Pa" || unit == "N")
    for (const auto& [scale, prefix] : large)
      if (largest >= scale) return {scale, prefix + unit};
  if (small_too && (unit == "m" || unit == "m/s" || unit == "N"))
    for (const auto& [scale, prefix] : small)
      if (largest > 0 && largest >= scale / 10 && largest < 100 * scale) return {scale, prefix + unit};
  return {1, unit};
}

/// One of several measured numbers: trailing zeros are digits too, and what is rounding beside the rest is none.
std::string entry_text(double value, double largest, int digits) {
  return number_text(std::abs(value) > 1e-12 * largest ? value : 0, digits);
}

}  // namespace

void matrix_table(const char* title, const Mat3& a, int rows, int columns, const std::string& unit) {
  const double largest = a.topLeftCorner(rows, columns).cwiseAbs().maxCoeff();
  const auto [factor, shown] = common_unit(largest, unit, false);
  heading((shown.empty() ? std::string(title) : title + (" [" + shown + "]")).c_str());
  const float width = ImGui::GetContentRegionAvail().x / static_cast<float>(columns), left = ImGui::GetCursorPosX();
  const auto text = [&, f = factor](int i, int j, int digits) { return entry_text(a(i, j) / f, largest / f, digits); };
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
  const auto [factor, shown] = common_unit(v.head(d).cwiseAbs().maxCoeff(), unit, true);
  for (int a = 0; a < d; ++a) text += (a > 0 ? ", " : "") + entry_text(v[a] / factor, v.norm() / factor, digits);
  return text + ")" + (shown.empty() ? "" : " ") + pretty_unit(shown);
}

std::string index_text(const std::array<std::int32_t, 3>& index, int d) {
  std::string text = "(";
  for (std::size_t a = 0; a < static_cast<std::size_t>(d); ++a) text += (a > 0 ? ", " : "") + quantity(index[a], "", 9);
  return text + ")";
}

}  // namespace pf::app
