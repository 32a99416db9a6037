// Phase: the passes in execution order, and what each of their inputs and outputs is.
#include <fmt/format.h>

#include <algorithm>

#include "graph/compiler/image_size.h"
#include "graph/compiler/phases.h"

namespace nephrite::graph {
namespace {

class PassConnector {
  public:
    PassConnector(Compilation& work, Index node) : work_(work), plan_(work.plan), node_(node) {}

    void connect(PlannedPass& pass) {
        const LinkedNode& linked = work_.graph.nodes[node_];
        pass.node = node_;
        pass.iterations = work_.runs(node_) ? work_.iterations[node_] : 0;
        pass.view = linked.view;
        pass.forEach = linked.forEach;
        pass.extent = linked.formats.count > 0 ? outputExtent(linked) : work_.request.view;
        const Index placedAfter = work_.placedAfter[node_];
        if (placedAfter != noIndex) pass.placedAfter = work_.passOf[placedAfter];
        if (work_.runs(node_) && work_.usesTileList(node_))
            pass.tileList = work_.resources[work_.portIndex(linked.tileList, 0)];
        connectInputs(pass, linked);
        connectOutputs(pass, linked);
    }

  private:
    /// The extent of the first output; of one level if that is all that the pass writes.
    Extent outputExtent(const LinkedNode& linked) const {
        if (linked.role == NodeRole::TileList)
            return plan_.resources[work_.resources[linked.formats.first]].extent;
        const Extent extent = work_.extents[linked.formats.first];
        const Index modified = work_.modifiedBy(linked.formats.first);
        if (modified == noIndex || !work_.inputIsRead[modified]) return extent;
        const LinkedInput& input = work_.graph.inputs[modified];
        return input.mip == every ? extent : levelExtent(extent, input.mip);
    }

    void connectInputs(PlannedPass& pass, const LinkedNode& linked) {
        pass.inputs = {static_cast<Index>(plan_.inputs.size()), linked.inputs.count};
        for (Index i = linked.inputs.first; i < linked.inputs.first + linked.inputs.count; ++i) {
            InputRead& read = plan_.inputs.emplace_back();
            connectInput(read, i);
            pass.readsConstants |= read.resource == noIndex;
        }
    }

    void connectInput(InputRead& read, Index i) {
        const LinkedInput& input = work_.graph.inputs[i];
        read.extent = work_.request.view;
        read.mip = input.mip;
        read.layer = input.layer;
        if (input.sourceNode == noIndex) return;
        read.extent = work_.extents[work_.portIndex(input.sourceNode, input.sourcePort)];
        read.perIteration = work_.graph.nodes[node_].forEach == ForEach::Lights &&
                            work_.graph.nodes[input.sourceNode].forEach == ForEach::Lights &&
                            input.layer == every;
        const Index port = work_.contentsOf(input);
        if (work_.inputIsRead[i] && work_.runs(node_) && port != noIndex) {
            read.resource = resourceOf(port, input.framesBack);
            if (read.resource != noIndex) checkSubresources(read, i);
        }
        if (read.mip != every) read.extent = levelExtent(read.extent, read.mip);
    }

    Index resourceOf(Index port, std::uint16_t framesBack) const {
        Index resource = work_.resources[port];
        for (std::uint16_t back = 0; back < framesBack && resource != noIndex; ++back)
            resource = resource < work_.older.size() ? work_.older[resource] : noIndex;
        return resource;
    }

    /// Most inputs show all there is, and their resource need not be looked at.
    void checkSubresources(const InputRead& read, Index input) {
        if (read.mip != every) check(read, input, read.mip, plan_.resources[read.resource].mips, "level");
        if (read.layer != every)
            check(read, input, read.layer, plan_.resources[read.resource].layers, "layer");
    }

    void check(const InputRead& read, Index input, std::uint32_t index, std::uint32_t count,
               std::string_view what) {
        if (index < count) return;
        work_.faults.error(whereOfInput(input), fmt::format("{} has {} {}{}, found {} (the first is 0)",
                                                            plan_.nameOf(plan_.resources[read.resource]),
                                                            count, what, count == 1 ? "" : "s", index));
    }

    const SourceLocation& whereOfInput(Index input) const {
        const NodeDescription& description = work_.description(node_);
        const Index port = input - work_.graph.nodes[node_].inputs.first;
        for (const auto& [name, reference] : description.inputs) {
            if (name == work_.typeOf(node_).inputs[port].name) return reference.where;
        }
        return description.where;
    }

    void connectOutputs(PlannedPass& pass, const LinkedNode& linked) {
        pass.outputs = {static_cast<Index>(plan_.outputs.size()), linked.formats.count};
        bool modifies = false;
        for (Index port = 0; port < linked.formats.count; ++port) {
            const Index flat = linked.formats.first + port;
            plan_.outputs.push_back(work_.resources[flat]);
            const Index modified = work_.modifiedBy(flat);
            if (modified == noIndex || pass.iterations == 0) continue;
            modifies = true;
            InputRead& read = plan_.inputs[pass.inputs.first + modified - linked.inputs.first];
            read.modified = read.resource != noIndex;
            const bool readsWhatItWrites = !linked.isRaster;
            if (!read.modified && readsWhatItWrites) pass.clearsFirst = true;
        }
        // A tile list counts its tiles; a pass over tiles leaves all others as they are.
        if (linked.role == NodeRole::TileList || pass.tileList != noIndex) pass.clearsFirst = true;
        pass.isRaster = linked.isRaster;
        pass.isPlain = !modifies && !pass.clearsFirst && pass.iterations > 0 && pass.forEach != ForEach::Mips;
    }

    Compilation& work_;
    Plan& plan_;
    Index node_;
};

}  // namespace

void connectPasses(Compilation& work) {
    Plan& plan = work.plan;
    work.passOf.assign(work.graph.nodes.size(), noIndex);
    plan.passes.reserve(work.order.size());
    plan.inputs.reserve(work.graph.inputs.size());
    plan.outputs.reserve(plan.resources.size());
    Index batch = 0;
    for (const Index node : work.order) {
        work.passOf[node] = static_cast<Index>(plan.passes.size());
        PlannedPass& pass = plan.passes.emplace_back();
        PassConnector(work, node).connect(pass);
        pass.firstBatch = batch;
        batch += pass.batchCount();
        if (work.graph.nodes[node].role == NodeRole::TileList)
            plan.tileLists.push_back(plan.outputs[pass.outputs.first]);
    }
    work.faults.throwIfErrors();
}

}  // namespace nephrite::graph
