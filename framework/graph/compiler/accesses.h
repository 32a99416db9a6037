// What a pass does to its resources, in the order of its batch points: the one list that lifetimes and
// barriers are made from.
#pragma once

#include "graph/plan.h"

namespace nephrite::graph {

/// One use of a part of a resource between two batch points. Several uses at once are all reads.
struct Access {
    Index resource = noIndex;
    Index batch = 0;         ///< the batch point it follows
    std::uint32_t uses = 0;  ///< bits (1 << Use)
    Layout layout = Layout::Undefined;
    bool writes = false;
    bool discards = false;  ///< nothing of what was there is kept
    std::uint16_t mip = every;
    std::uint16_t layer = every;
    Index lastBatch = 0;  ///< the last batch point it follows, if it goes on behind several
};

inline Layout layoutOfAccess(const Plan& plan, const Resource& resource, Use use) {
    return resource.isBuffer ? Layout::Undefined : layoutOf(use, plan.inputReads, resource.format);
}

/// How a pass writes one of its outputs.
struct OutputAccess {
    Use use = Use::ComputeWrite;
    bool modifies = false;  ///< what is there is kept where the pass writes nothing
    std::uint16_t mip = every;
    std::uint16_t layer = every;
};

inline Use writingUse(const Resource& resource, bool isRaster) {
    if (!isRaster || resource.isBuffer) return Use::ComputeWrite;
    return resource.format == Format::d32f ? Use::DepthAttachment : Use::ColorAttachment;
}

inline OutputAccess outputAccess(const Plan& plan, const PlannedPass& pass, Index port) {
    const PassType& type = plan.typeOf(pass);
    const Resource& resource = plan.resources[plan.outputs[pass.outputs.first + port]];
    const Index input = type.outputs[port].modifiedInput;
    const InputRead* modified = input == noIndex ? nullptr : &plan.inputs[pass.inputs.first + input];
    OutputAccess access;
    access.modifies = (modified != nullptr && modified->modified) || isCleared(plan, pass, port);
    access.use = writingUse(resource, pass.isRaster);
    if (access.use == Use::ComputeWrite && access.modifies) access.use = Use::ComputeModify;
    if (modified != nullptr && modified->modified) {
        access.mip = modified->mip;
        access.layer = modified->layer;
    }
    return access;
}

/// Calls `visit` with each Access of a pass, in the order of their batch points.
template<class Visit>
void forEachAccess(const Plan& plan, const PlannedPass& pass, Visit visit) {
    const bool isRaster = pass.isRaster;
    const auto access = [&](Index resource, Index batch, Use use, std::uint16_t mip = every,
                            std::uint16_t layer = every, bool modifies = false) {
        visit(Access{resource, batch, bit(use), layoutOfAccess(plan, plan.resources[resource], use),
                     writes(use), writes(use) && !modifies, mip, layer});
    };
    if (pass.iterations == 0 || pass.clearsFirst) {
        for (Index port = 0; port < pass.outputs.count; ++port) {
            if (isCleared(plan, pass, port))
                access(plan.outputs[pass.outputs.first + port], pass.firstBatch, Use::Clear);
        }
        if (pass.iterations == 0) return;
    }
    // Every iteration reads the inputs.
    const Index batch = pass.firstBatch + (pass.clearsFirst ? 1 : 0);
    const Index lastBatch = pass.firstBatch + pass.batchCount() - 1;
    for (const InputRead& input : slice(plan.inputs, pass.inputs)) {
        if (input.resource == noIndex || input.modified) continue;
        const Use use = isRaster ? Use::RasterRead : Use::ComputeRead;
        visit(Access{input.resource, batch, bit(use),
                     layoutOfAccess(plan, plan.resources[input.resource], use), false, false, input.mip,
                     input.layer, lastBatch});
    }
    if (pass.tileList != noIndex)
        visit(Access{pass.tileList, batch, bit(Use::Indirect) | bit(Use::ComputeRead), Layout::Undefined,
                     false, false, every, every, lastBatch});
    if (pass.isPlain) {
        for (const Index output : slice(plan.outputs, pass.outputs))
            access(output, batch, writingUse(plan.resources[output], isRaster));
        return;
    }
    const std::uint32_t levels = pass.forEach == ForEach::Mips ? pass.iterations : 1;
    for (std::uint32_t level = 0; level < levels; ++level) {
        for (Index port = 0; port < pass.outputs.count; ++port) {
            const OutputAccess write = outputAccess(plan, pass, port);
            const Index output = plan.outputs[pass.outputs.first + port];
            if (level > 0)
                access(output, batch + level, Use::ComputeLevelRead, static_cast<std::uint16_t>(level - 1),
                       write.layer);
            const auto mip = pass.forEach == ForEach::Mips ? static_cast<std::uint16_t>(level) : write.mip;
            access(output, batch + level, write.use, mip, write.layer, write.modifies);
        }
    }
}

}  // namespace nephrite::graph
