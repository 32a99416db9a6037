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

/// Each resource has memory of its own, so none has a place in a common heap.
void writeResource(const Plan& plan, const Resource& resource, Output out) {
    fmt::format_to(out,
                   R"(    {{"name": {}, "format": {}, "width": {}, "height": {}, "mips": {}, "layers": {}, )",
                   jsonString(plan.nameOf(resource)), jsonString(formatName(plan, resource)),
                   resource.extent.width, resource.extent.height, resource.mips, resource.layers);
    fmt::format_to(out, R"("bytes": {}, "offset": null, "first": {}, "last": {}}})", resource.bytes,
                   resource.first, resource.last);
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
                        plan.barriers.size(), plan.barrierBatches, plan.naiveBarriers);
    text += fmt::format("  \"heapBytes\": 0,\n  \"naiveBytes\": {},\n  \"peakLiveBytes\": {}\n}}\n",
                        plan.naiveBytes, plan.peakLiveBytes);
    return text;
}

}  // namespace nephrite::graph
