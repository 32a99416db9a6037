// Runs a suite: references, pictures, errors, times.
#pragma once

#include <filesystem>
#include <string>

#include "pareto/prepare.h"
#include "pareto/progress.h"
#include "pareto/results.h"
#include "pareto/suite.h"

namespace nephrite::pareto {

struct RunOptions {
    std::filesystem::path folder;  ///< references are kept in its sub-folder `references`
    std::string device;            ///< part of a device's name; empty: the best there is
    std::string commit;            ///< of the program
    unsigned threads = 1;
};

/// Measures what was prepared of the suite. Throws InputError if a graph cannot render a scene or there is
/// no such device; RunError if something fails or is interrupted.
SuiteResult runSuite(const Suite& suite, const Preparation& preparation, const RunOptions& options,
                     const Progress& progress);

}  // namespace nephrite::pareto
