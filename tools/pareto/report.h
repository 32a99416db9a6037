// A suite's results as files: JSON with everything, CSV for spreadsheets, a table for people, a plot's
// script.
#pragma once

#include <string>

#include "pareto/results.h"

namespace nephrite::pareto {

/// Everything; docs/benchmarks.md has the keys.
std::string resultsAsJson(const SuiteResult& result);

/// One line for each comparison, and for each point that was only timed.
std::string resultsAsCsv(const SuiteResult& result);
/// One line for each pass of each point.
std::string passesAsCsv(const SuiteResult& result);

/// Markdown: scenes by references down, methods across, each by its first combination of values.
std::string resultsAsTable(const SuiteResult& result);

/// A gnuplot script with its data: time over error, a panel for each scene and reference, the front as a
/// stair line. Empty if nothing was both timed and compared. `gnuplot pareto.gp > pareto.svg`, or
/// `gnuplot -e 'format="png"' pareto.gp > pareto.png`.
std::string resultsAsPlot(const SuiteResult& result);

}  // namespace nephrite::pareto
