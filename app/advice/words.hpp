// What an advisor's measurements say, in words.
#pragma once

#include <string>

#include "core/advice/advice.hpp"

namespace pf::app {

/// "27 % of the work. Error 3.1 µm after 80 ms, as it is 3.0 µm."
std::string evidence(const AdviceReport& report, const Trial& trial);
/// How the errors were measured, and what they leave open.
std::string basis_of_judgement(const AdviceReport& report);
/// What is said where there is nothing to advise; "" where there is.
std::string no_advice(const AdviceReport& report);
/// "62 % of the cells are at rest"; "" where everything moves.
std::string resting_words(const AdviceReport& report);

}  // namespace pf::app
