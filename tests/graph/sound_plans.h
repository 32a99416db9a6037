// Plans that the oracle finds nothing wrong with, and their barriers, for tests of what graphs mean.
#pragma once

#include <gmock/gmock.h>

#include <string_view>
#include <vector>

#include "graph/plan_support.h"

namespace nephrite::graph::tests {

/// The plan, after the oracle has seen nothing wrong with it.
Plan soundPlanOf(std::string_view graph, CompileRequest request = tests::request());

/// A request on a device that reads images through samplers.
CompileRequest sampled();

/// A request with one import, which is made 16 x 16.
CompileRequest withImport(ImportedImage image);

/// The barriers over exactly this part of a resource, in the order of their batches.
std::vector<Barrier> barriersOver(const Plan& plan, std::string_view resource, Subresources part);

/// Matches a barrier by what is awaited by what.
inline auto waits(Use before, Use after) {
    return testing::AllOf(testing::Field(&Barrier::usesBefore, bit(before)),
                          testing::Field(&Barrier::usesAfter, bit(after)));
}

}  // namespace nephrite::graph::tests
