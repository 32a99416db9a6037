// A node's output ports in GLSL.
#include <algorithm>

#include "runtime/interface/draft.h"

namespace nephrite::runtime {
namespace {

using Kind = PortDescriptor::Kind;

void addAttachment(InterfaceDraft& draft, const ImagePort& functions, bool isDepth) {
    if (!isDepth) draft.add(functions.attachment(draft.nextLocation()));
    draft.add(functions.attachmentFunctions());
}

/// The level that an iteration writes, and those above it.
void addIterationLevels(InterfaceDraft& draft, const ImagePort& functions, graph::Index port,
                        OutputAccess access) {
    const graph::Index resource = draft.output(port);
    const std::uint32_t mips = draft.imageOfOutput(port).mips;
    const std::uint32_t written = draft.addDescriptor(Kind::StorageImage, resource, graph::every,
                                                      graph::every, PortDescriptor::Level::Iteration);
    draft.add(functions.outputImage(written, 0, access));
    for (std::uint32_t mip = 0; mip + 1 < std::max(mips, 2U); ++mip) {
        const std::uint32_t above =
            draft.addDescriptor(Kind::StorageImage, resource, static_cast<std::uint16_t>(mip), graph::every,
                                PortDescriptor::Level::Above);
        draft.add(functions.levelAbove(above, mip));
    }
    draft.add(functions.outputFunctions(OutputAccess::Mips));
}

void addLevels(InterfaceDraft& draft, const ImagePort& functions, graph::Index port, OutputAccess access) {
    const graph::InputRead part = draft.partOfOutput(port);
    const std::uint32_t mips = draft.imageOfOutput(port).mips;
    for (std::uint32_t mip = 0; mip < mips; ++mip) {
        const auto level = static_cast<std::uint16_t>(part.mip == graph::every ? mip : part.mip);
        const std::uint32_t binding =
            draft.addDescriptor(Kind::StorageImage, draft.output(port), level, part.layer);
        draft.add(functions.outputImage(binding, mip, access));
    }
    draft.add(functions.outputFunctions(access));
}

}  // namespace

void addOutput(InterfaceDraft& draft, graph::Index port) {
    const graph::Resource& resource = draft.plan().resources[draft.output(port)];
    const graph::OutputPort& declared = draft.type().outputs[port];
    if (resource.isBuffer)
        return draft.addBuffer(declared.name, declared.bufferElement, draft.output(port), "");
    const ImagePort functions(declared.name, draft.imageOfOutput(port), draft.isOverLights());
    if (draft.isRaster()) return addAttachment(draft, functions, graph::info(resource.format).isDepth);
    const OutputAccess access =
        declared.modifiedInput == graph::noIndex ? OutputAccess::Write : OutputAccess::Modify;
    if (draft.isOverMips()) {
        addIterationLevels(draft, functions, port,
                           access == OutputAccess::Write ? OutputAccess::Mips : access);
    } else {
        addLevels(draft, functions, port, access);
    }
}

}  // namespace nephrite::runtime
