// See plan_oracle_accesses.h.
#include "graph/plan_oracle_accesses.h"

namespace nephrite::graph::tests {
namespace {

bool isDepth(const Resource& resource) {
    return !resource.isBuffer && resource.format == Format::d32f;
}

Use readUse(bool isRaster) {
    return isRaster ? Use::RasterRead : Use::ComputeRead;
}

/// How a pass that runs writes an output.
Use writeUse(bool isRaster, bool loads, const Resource& resource) {
    if (isRaster) return isDepth(resource) ? Use::DepthAttachment : Use::ColorAttachment;
    return loads ? Use::ComputeModify : Use::ComputeWrite;
}

void listInputs(const Plan& plan, const PlannedPass& pass, bool isRaster,
                std::vector<OracleAccess>& accesses) {
    for (const InputRead& input : slice(plan.inputs, pass.inputs)) {
        if (input.resource == noIndex || input.modified) continue;
        accesses.push_back({input.resource, readUse(isRaster),
                            selected(plan.resources[input.resource], input.mip, input.layer), false});
    }
    if (pass.tileList == noIndex) return;
    const Subresources whole = plan.resources[pass.tileList].whole();
    accesses.push_back({pass.tileList, Use::Indirect, whole, false});
    accesses.push_back({pass.tileList, Use::ComputeRead, whole, false});
}

/// An output of a pass, as its shader writes it.
struct WrittenPort {
    Index resource = noIndex;
    bool modifies = false;  ///< an input: it is there before
    bool loads = false;     ///< the shader may read it
    Subresources range;
};

WrittenPort writtenPort(const Plan& plan, const PlannedPass& pass, Index port) {
    WrittenPort written;
    written.resource = plan.outputs[pass.outputs.first + port];
    if (written.resource == noIndex) return written;
    const PassType& type = plan.typeOf(pass);
    const Resource& resource = plan.resources[written.resource];
    written.range = resource.whole();
    // A list counts its tiles, and a pass over tiles leaves all others as they are.
    written.loads = pass.tileList != noIndex || plan.graph->nodes[pass.node].role == NodeRole::TileList;
    const Index modified = type.outputs[port].modifiedInput;
    if (modified == noIndex) return written;
    const InputRead& input = plan.inputs[pass.inputs.first + modified];
    written.modifies = input.modified && input.resource != noIndex;
    written.loads |= written.modifies || type.kind != PassKind::Raster;
    if (written.modifies) written.range = selected(resource, input.mip, input.layer);
    return written;
}

/// Outputs that nothing was written to yet are cleared instead of running, or before a shader that reads
/// them.
void listClears(const Plan& plan, const PlannedPass& pass, std::vector<OracleAccess>& accesses) {
    for (Index port = 0; port < pass.outputs.count; ++port) {
        const WrittenPort written = writtenPort(plan, pass, port);
        if (written.resource == noIndex || written.modifies) continue;
        if (pass.iterations == 0 || written.loads)
            accesses.push_back({written.resource, Use::Clear, written.range, false});
    }
}

void listWrites(const Plan& plan, const PlannedPass& pass, Index iteration,
                std::vector<OracleAccess>& accesses) {
    const bool isRaster = plan.typeOf(pass).kind == PassKind::Raster;
    const auto reads = static_cast<std::ptrdiff_t>(accesses.size());
    for (Index port = 0; port < pass.outputs.count; ++port) {
        WrittenPort written = writtenPort(plan, pass, port);
        if (written.resource == noIndex) continue;
        const Resource& resource = plan.resources[written.resource];
        if (pass.forEach == ForEach::Mips && !resource.isBuffer) {
            written.range.baseMip = iteration;
            written.range.mips = iteration < resource.mips ? 1 : 0;
            Subresources above = written.range;
            above.baseMip = iteration - 1;
            above.mips = 1;
            if (iteration > 0)
                accesses.insert(accesses.begin() + reads,
                                {written.resource, Use::ComputeLevelRead, above, false});
        }
        accesses.push_back(
            {written.resource, writeUse(isRaster, written.loads, resource), written.range, written.loads});
    }
}

}  // namespace

bool isWrite(Use use) {
    constexpr Uses all = maskOf(Use::ComputeWrite) | maskOf(Use::ComputeModify) |
                         maskOf(Use::ColorAttachment) | maskOf(Use::DepthAttachment) | maskOf(Use::Clear);
    return (all & maskOf(use)) != 0;
}

Layout neededLayout(Use use, const Plan& plan, const Resource& resource) {
    if (resource.isBuffer) return Layout::Undefined;
    switch (use) {
        case Use::ComputeRead:
        case Use::RasterRead:
            return isDepth(resource) || plan.inputReads == InputReads::SampledImage ? Layout::ShaderRead
                                                                                    : Layout::General;
        case Use::ColorAttachment:
            return Layout::ColorAttachment;
        case Use::DepthAttachment:
            return Layout::DepthAttachment;
        case Use::Clear:
            return Layout::TransferDestination;
        case Use::Copy:
            return resource.final != Layout::Undefined ? resource.final : Layout::TransferSource;
        default:
            return Layout::General;
    }
}

Subresources selected(const Resource& resource, std::uint16_t mip, std::uint16_t layer) {
    Subresources range = resource.whole();
    if (mip != every) range = {mip, mip < resource.mips ? 1U : 0U, range.baseLayer, range.layers};
    if (layer != every) {
        range.baseLayer = layer;
        range.layers = layer < resource.layers ? 1 : 0;
    }
    return range;
}

void listAccesses(const Plan& plan, const PlannedPass& pass, Index batch,
                  std::vector<OracleAccess>& accesses) {
    accesses.clear();
    if (pass.iterations == 0 || (pass.clearsFirst && batch == 0)) return listClears(plan, pass, accesses);
    listInputs(plan, pass, plan.typeOf(pass).kind == PassKind::Raster, accesses);
    listWrites(plan, pass, batch - (pass.clearsFirst ? 1 : 0), accesses);
}

void listCopies(const Plan& plan, std::vector<OracleAccess>& accesses) {
    accesses.clear();
    for (const RequestedOutput& output : plan.requested) {
        if (output.resource == noIndex) continue;
        accesses.push_back({output.resource, Use::Copy,
                            selected(plan.resources[output.resource], output.mip, output.layer), false});
    }
}

}  // namespace nephrite::graph::tests
