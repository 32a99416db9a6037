// Looks at all that a suite names before any of it is rendered.
#pragma once

#include <vector>

#include "pareto/points.h"
#include "pareto/progress.h"
#include "pareto/results.h"
#include "pareto/suite.h"

namespace nephrite::pareto {

/// A scene that can be rendered, and what is measured of it.
struct Task {
    const SuiteScene* scene = nullptr;
    std::vector<Point> points;
};

struct Preparation {
    std::vector<Task> tasks;
    std::vector<LeftOutScene> leftOut;
};

/// The selected scenes and points, which point into the suite. Every scene and every graph has been read,
/// with each point's settings; each compared port is there, and each reference suits its scene. Scenes whose
/// models are not at hand are left out, with a line that says so. Throws InputError with the place in the
/// suite of what is wrong.
Preparation prepareSuite(const Suite& suite, const Selection& selection, const Progress& progress);

}  // namespace nephrite::pareto
