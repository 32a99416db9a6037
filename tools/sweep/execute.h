// Renders the runs of a sweep, one after the other, in as few sessions as can be.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pareto/progress.h"
#include "sweep/sweep.h"
#include "truth/tiles.h"

namespace nephrite::sweep {

struct SweepOptions {
    std::filesystem::path folder;  ///< where runs, pictures and tables go
    truth::Part part;              ///< every N-th run from the I-th
    std::vector<std::filesystem::path> passPaths;
    std::string device;  ///< part of a device's name; empty: the best there is
    std::string commit;  ///< of the program
};

/// What is there after an execution.
struct SweepState {
    std::size_t runs = 0;           ///< of the whole sweep
    std::vector<Json::Value> rows;  ///< those done, by this execution or another, in the order of the sweep

    bool isComplete() const { return rows.size() == runs; }
};

/// Renders those runs of the part that are not done yet. A run that fails is said and left out. Throws
/// InputError if the sweep is wrong, before anything is rendered; RunError if a run failed, after the others
/// are done, or when told to stop.
SweepState execute(const Sweep& sweep, const SweepOptions& options, const pareto::Progress& progress);

}  // namespace nephrite::sweep
