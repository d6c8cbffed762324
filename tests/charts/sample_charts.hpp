// The four kinds of chart that the product shows, with data shaped like the real thing: used by several tests, and
// written as pictures by the gallery test.
#pragma once

#include "core/charts/chart.hpp"

namespace pf::test {

Chart energy_chart();          ///< curves of energies over time, a pinned run behind
Chart work_precision_chart();  ///< log-log, slopes, Pareto front, error bars
Chart convergence_chart();     ///< Newton's residual by iteration, zeros and gaps in it
Chart stability_chart();       ///< heat map with hatched classes
Chart phase_chart();           ///< bars with named places
Chart field_chart();           ///< cells with a colour bar

}  // namespace pf::test
