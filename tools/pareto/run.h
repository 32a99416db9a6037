// Runs a suite: references, pictures, errors, times.
#pragma once

#include <filesystem>
#include <string>

#include "pareto/points.h"
#include "pareto/progress.h"
#include "pareto/results.h"
#include "pareto/suite.h"

namespace nephrite::pareto {

struct RunOptions {
    std::filesystem::path folder;  ///< references are kept in its sub-folder `references`
    Selection selection;
    std::string device;  ///< part of a device's name; empty: the best there is
    std::string commit;  ///< of the program
    unsigned threads = 1;
};

/// Scenes whose models are not at hand are left out, with a line that says so. Throws InputError if a graph,
/// a scene or the selection is wrong, before anything long begins where that can be seen; RunError if
/// something fails or is interrupted.
SuiteResult runSuite(const Suite& suite, const RunOptions& options, const Progress& progress);

}  // namespace nephrite::pareto
