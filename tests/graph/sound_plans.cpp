// See sound_plans.h.
#include "graph/sound_plans.h"

#include "graph/plan_oracle.h"

namespace nephrite::graph::tests {

Plan soundPlanOf(std::string_view graph, CompileRequest request) {
    Plan plan = planOf(graph, request);
    request.graph = plan.graph;
    EXPECT_THAT(findFaults(request, plan), testing::IsEmpty());
    return plan;
}

CompileRequest sampled() {
    CompileRequest result = request();
    result.inputReads = InputReads::SampledImage;
    return result;
}

std::vector<Barrier> barriersOver(const Plan& plan, std::string_view resource, Subresources part) {
    const auto index = static_cast<Index>(&resourceNamed(plan, resource) - plan.resources.data());
    std::vector<Barrier> found;
    for (const Range& batch : plan.schedule.batches) {
        for (const Barrier& barrier : slice(plan.schedule.barriers, batch)) {
            if (barrier.resource == index && barrier.range == part) found.push_back(barrier);
        }
    }
    return found;
}

CompileRequest withImport(ImportedImage image) {
    CompileRequest result = request();
    image.extent = {16, 16};
    result.imports = {image};
    return result;
}

}  // namespace nephrite::graph::tests
