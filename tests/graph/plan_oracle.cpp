// See plan_oracle.h.
#include "graph/plan_oracle.h"

#include "graph/plan_oracle_figures.h"
#include "graph/plan_oracle_truth.h"
#include "graph/plan_oracle_walk.h"

namespace nephrite::graph::tests {

std::vector<std::string> findHazards(const Plan& plan) {
    return findHazards(plan, {}, plan.schedule);
}

std::vector<std::string> findHazards(const Plan& plan, std::span<const std::uint8_t> runs,
                                     const BarrierSchedule& schedule) {
    std::vector<std::string> findings = FrameWalk(plan, runs, schedule).run();
    checkOverlaps(plan, findings);
    return findings;
}

std::vector<std::string> findFaults(const CompileRequest& request, const Plan& plan) {
    std::vector<std::string> findings = FrameWalk(plan, {}, plan.schedule).run();
    checkOverlaps(plan, findings);
    checkFigures(request, plan, findings);
    checkAgainstTruth(GraphTruth(request, plan), plan, findings);
    return findings;
}

}  // namespace nephrite::graph::tests
