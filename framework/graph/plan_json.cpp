// A plan for programs: the JSON contract of `nephrite plan -o F.json`.
#include <fmt/format.h>
#include <json/writer.h>

#include <iterator>

#include "graph/plan_words.h"
#include "graph/plan_writer.h"

namespace nephrite::graph {
namespace {

using Output = std::back_insert_iterator<std::string>;

std::string jsonString(std::string_view text) {
    return Json::valueToQuotedString(std::string(text).c_str());
}

void writePass(const Plan& plan, Index node, Output out) {
    const PassType& type = *plan.graph->nodes[node].type;
    fmt::format_to(out, R"(    {{"name": {}, "type": {}, "kind": {}, "state": {}, "why": {}}})",
                   jsonString(plan.graph->nodeName(node)), jsonString(type.name), jsonString(name(type.kind)),
                   jsonString(name(plan.nodes[node].state)), jsonString(whyOf(plan, node)));
}

/// An index or a byte, null where there is none.
std::string orNull(std::uint64_t value, bool exists) {
    return exists ? std::to_string(value) : "null";
}

void writeResource(const Plan& plan, const Resource& resource, Output out) {
    fmt::format_to(out,
                   R"(    {{"name": {}, "format": {}, "width": {}, "height": {}, "mips": {}, "layers": {}, )",
                   jsonString(plan.nameOf(resource)), jsonString(formatName(plan, resource)),
                   resource.extent.width, resource.extent.height, resource.mips, resource.layers);
    const bool isUsed = resource.first != noIndex;
    fmt::format_to(out, R"("bytes": {}, "offset": {}, "first": {}, "last": {}}})", resource.bytes,
                   orNull(resource.offset, resource.offset != Resource::noOffset),
                   orNull(resource.first, isUsed), orNull(resource.last, isUsed));
}

void writePolicy(const PolicyFigures& figures, Output out) {
    fmt::format_to(out, R"(    {{"policy": "{}", "barrierBatches": {}, "heapBytes": {}}})",
                   name(figures.policy), figures.barrierBatches, figures.heapBytes);
}

/// `[`, one line an element, `]`.
template<class Elements, class Write>
void writeArray(std::string& text, const Elements& elements, Write write) {
    text += '[';
    bool first = true;
    for (const auto& element : elements) {
        text += first ? "\n" : ",\n";
        first = false;
        write(element);
    }
    text += first ? "]" : "\n  ]";
}

}  // namespace

std::string planAsJson(const Plan& plan) {
    std::string text = "{\n  \"passes\": ";
    writeArray(text, nodesInReportOrder(plan),
               [&](Index node) { writePass(plan, node, std::back_inserter(text)); });
    text += ",\n  \"resources\": ";
    writeArray(text, plan.resources,
               [&](const Resource& resource) { writeResource(plan, resource, std::back_inserter(text)); });
    text += fmt::format(",\n  \"barriers\": {},\n  \"barrierBatches\": {},\n  \"naiveBarriers\": {},\n",
                        plan.schedule.barriers.size(), plan.schedule.batchCount, plan.naiveBarriers);
    text += fmt::format("  \"heapBytes\": {},\n  \"naiveBytes\": {},\n  \"peakLiveBytes\": {},\n",
                        plan.heapBytes, plan.naiveBytes, plan.peakLiveBytes);
    text += fmt::format("  \"policy\": \"{}\",\n  \"policies\": ", name(plan.policy));
    std::vector<PolicyFigures> policies{plan.figures()};
    if (plan.otherPolicy) policies.push_back(*plan.otherPolicy);
    writeArray(text, policies,
               [&](const PolicyFigures& figures) { writePolicy(figures, std::back_inserter(text)); });
    text += fmt::format(
        ",\n  \"skips\": {{\"notNeeded\": {}, \"neutral\": {}, \"keepable\": {}, \"tiled\": {}, "
        "\"specialized\": {}}}\n}}\n",
        plan.skips.notNeeded, plan.skips.neutral, plan.skips.keepable, plan.skips.tiled,
        plan.skips.specialized);
    return text;
}

}  // namespace nephrite::graph
