// Comparing plans member by member.
#include "runtime/planning/plan_equality.h"

#include <algorithm>
#include <tuple>

namespace nephrite::runtime {
namespace {

template<class Element, class Same>
bool sameLists(const std::vector<Element>& a, const std::vector<Element>& b, Same same) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

bool sameRanges(graph::Range a, graph::Range b) {
    return a.first == b.first && a.count == b.count;
}

bool samePasses(const graph::PlannedPass& a, const graph::PlannedPass& b) {
    const auto members = [](const graph::PlannedPass& pass) {
        return std::tie(pass.node, pass.iterations, pass.extent.width, pass.extent.height, pass.firstBatch,
                        pass.tileList, pass.view, pass.forEach, pass.clearsFirst);
    };
    return members(a) == members(b) && sameRanges(a.inputs, b.inputs) && sameRanges(a.outputs, b.outputs);
}

bool sameResources(const graph::Resource& a, const graph::Resource& b) {
    const auto shape = [](const graph::Resource& r) {
        return std::tie(r.node, r.port, r.extent.width, r.extent.height, r.mips, r.layers,
                        r.layersPerIteration, r.format, r.isBuffer, r.bytes);
    };
    const auto role = [](const graph::Resource& r) {
        return std::tie(r.offset, r.uses, r.first, r.last, r.framesBack, r.kind, r.requested, r.bySubresource,
                        r.initial, r.final, r.importedUses, r.memoryUsedUntil, r.memoryUsesBefore);
    };
    return shape(a) == shape(b) && role(a) == role(b);
}

bool sameInputs(const graph::InputRead& a, const graph::InputRead& b) {
    const auto members = [](const graph::InputRead& read) {
        return std::tie(read.resource, read.extent.width, read.extent.height, read.mip, read.layer,
                        read.perIteration, read.modified);
    };
    return members(a) == members(b);
}

bool sameRequests(const graph::RequestedOutput& a, const graph::RequestedOutput& b) {
    return a.name == b.name && a.resource == b.resource && a.mip == b.mip && a.layer == b.layer;
}

/// Which constant stands for a source that does not run follows from these.
bool sameDecisions(const graph::NodeDecision& a, const graph::NodeDecision& b) {
    return a.state == b.state && a.reason == b.reason;
}

}  // namespace

bool doTheSame(const graph::Plan& a, const graph::Plan& b) {
    return a.graph == b.graph && a.view == b.view && a.lightViews == b.lightViews &&
           a.inputReads == b.inputReads && a.heapBytes == b.heapBytes && a.outputs == b.outputs &&
           sameLists(a.passes, b.passes, samePasses) && sameLists(a.resources, b.resources, sameResources) &&
           sameLists(a.inputs, b.inputs, sameInputs) && sameLists(a.requested, b.requested, sameRequests) &&
           sameLists(a.nodes, b.nodes, sameDecisions);
}

}  // namespace nephrite::runtime
