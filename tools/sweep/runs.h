// The runs of a sweep, in order.
#pragma once

#include <string>
#include <vector>

#include "sweep/sweep.h"

namespace nephrite::sweep {

/// One row: a scene, a graph, a size, and a value for each parameter. Points into its sweep.
struct Run {
    const SweepScene* scene = nullptr;
    const SweepGraph* graph = nullptr;
    graph::Extent size;
    std::vector<const Setting*> parameters;  ///< of the list and the grid

    /// "apple/paper/64x64 dipole.taps=4": what tells it from the others.
    std::string name() const;
    /// 16 hexadecimal digits that stay the same when other runs come or go, or parameters change places.
    std::string id() const;
    /// All, the graph's own first.
    std::vector<std::string> settings() const;
};

/// Scenes change slowest, then graphs, sizes, sets of the list, and the grid's parameters; the last fastest.
std::vector<Run> runsOf(const Sweep& sweep);

}  // namespace nephrite::sweep
