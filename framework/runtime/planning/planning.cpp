// Asking the compiler for plans.
#include "runtime/planning/planning.h"

#include <fmt/format.h>

#include "runtime/resources/resource_descriptions.h"

namespace nephrite::runtime {
namespace {

graph::CompileRequest requestOf(const PlanningContext& context, const GraphContent& content,
                                const scene::Facts& facts) {
    const SessionOptions& options = context.options;
    graph::CompileRequest request = content.request(context.reads);
    request.facts = sceneFacts(facts);
    request.view = options.size;
    request.skip = options.skip;
    request.policy = options.policy;
    request.plain = options.plain;
    request.memory = memoryNeedsOn(context.device, context.reads);
    request.maxExtent = context.device.maxImageExtent();
    request.maxLayers = context.device.maxImageLayers();
    return request;
}

void omitBarrier(graph::Plan& plan, std::uint32_t index) {
    std::vector<graph::Barrier>& barriers = plan.schedule.barriers;
    if (index >= barriers.size())
        throw InputError({"--omit-barrier"},
                         fmt::format("the plan has {} barriers, found {}", barriers.size(), index));
    barriers[index].usesBefore = 0;
    barriers[index].usesAfter = 0;
    barriers[index].writeBefore = false;
}

graph::Plan makePlan(const PlanningContext& context, const GraphContent& content, const scene::Facts& facts,
                     ProgramCache& programs) {
    const SessionOptions& options = context.options;
    graph::CompileRequest request = requestOf(context, content, facts);
    graph::Plan plan = graph::compile(request);
    if (options.reuse && options.skip) {
        request.dependsOn = programs.scenePartsOf(plan, *content.values);
        request.keep = graph::Keep::AcrossRates;
        plan = graph::compile(request);
    }
    if (options.omitBarrier) omitBarrier(plan, *options.omitBarrier);
    return plan;
}

graph::Plan planWithoutSkipping(const PlanningContext& context, const GraphContent& content,
                                const scene::Facts& facts) {
    graph::CompileRequest request = requestOf(context, content, facts);
    request.skip = false;
    return graph::compile(request);
}

void buildPrograms(const graph::Plan& plan, const graph::ParameterValues& values, ProgramCache& programs) {
    for (const graph::PlannedPass& pass : plan.passes) {
        if (pass.iterations == 0) continue;
        programs.programOf(plan, pass, nodeInterface(plan, pass, values, programs.context().filterable));
    }
}

}  // namespace

Plans makePlans(const PlanningContext& context, const GraphContent& content, const scene::Facts& facts,
                ProgramCache& programs) {
    Plans plans{makePlan(context, content, facts, programs), std::nullopt};
    if (context.options.auditSkips) plans.plain = planWithoutSkipping(context, content, facts);
    return plans;
}

void buildPrograms(const Plans& plans, const GraphContent& content, ProgramCache& programs) {
    buildPrograms(plans.plan, *content.values, programs);
    if (plans.plain) buildPrograms(*plans.plain, *content.values, programs);
}

}  // namespace nephrite::runtime
