// Vectors and small matrices as they stand in the inspectors.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "core/types.hpp"

namespace pf::app {

/// Rows x columns of the upper left corner, right-aligned, with as many digits as fit.
void matrix_table(const char* title, const Mat3& a, int rows, int columns, const std::string& unit);
void vector_row(const char* title, const Vec3& v, int d, const char* unit);
/// "(0.120, −3.40) m/s", "(−0.0525, −2.69, 3.42) mm": one prefix for all.
std::string vector_text(const Vec3& v, int d, const char* unit, int digits = 3);
/// "(3, 4)"
std::string index_text(const std::array<std::int32_t, 3>& index, int d);

}  // namespace pf::app
