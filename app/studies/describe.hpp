// What the drawer says of settings, runs and times. No drawing.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/studies/row.hpp"
#include "core/studies/study.hpp"

namespace pf::app {

/// "Young's modulus (rubber)": a varied setting by its plain name; `of` what, where the scene has several.
std::string setting_title(const Scene& scene, const std::string& pointer);
/// "Symplectic Euler, time step 4 ms": a study's setting by what is varied.
std::string setting_words(const Study& study, std::size_t k);
/// A setting and what was measured of it, a line each, the setting first.
std::vector<std::string> row_words(const Study& study, const StudyRow& row);
/// "21 ms, 19 to 25 ms", "1.2e5 visits".
std::string cost_words(const Study& study, const StudyRow& row);
/// "12 s", "3 min", "1 h 20 min"; "" where it is not known.
std::string duration_words(double seconds);
/// "3 blew up, 1 failed"; "" where all went well.
std::string trouble_words(std::span<const StudyRow> rows);
/// Plain name of a class: "blown up".
std::string class_words(RunClass behaviour);

}  // namespace pf::app
