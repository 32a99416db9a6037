#include "graph/plan.h"

namespace nephrite::graph {

Layout layoutOf(Use use, InputReads reads, Format format) {
    switch (use) {
        case Use::None:
            return Layout::Undefined;
        case Use::ComputeRead:
        case Use::RasterRead:
            // A depth image cannot be a storage image.
            return reads == InputReads::StorageImage && !info(format).isDepth ? Layout::General
                                                                              : Layout::ShaderRead;
        case Use::ComputeWrite:
            return Layout::General;
        case Use::ColorAttachment:
            return Layout::ColorAttachment;
        case Use::DepthAttachment:
            return Layout::DepthAttachment;
        case Use::Clear:
            return Layout::TransferDestination;
        case Use::Copy:
            return Layout::TransferSource;
    }
    return Layout::Undefined;
}

bool writes(Use use) {
    return use == Use::ComputeWrite || use == Use::ColorAttachment || use == Use::DepthAttachment ||
           use == Use::Clear;
}

std::string_view name(NodeState state) {
    switch (state) {
        case NodeState::Run:
            return "run";
        case NodeState::Culled:
            return "culled";
        case NodeState::Skipped:
            return "skipped";
    }
    return "";
}

std::string_view name(Use use) {
    switch (use) {
        case Use::None:
            return "nothing";
        case Use::ComputeRead:
            return "compute read";
        case Use::ComputeWrite:
            return "compute write";
        case Use::RasterRead:
            return "raster read";
        case Use::ColorAttachment:
            return "color attachment";
        case Use::DepthAttachment:
            return "depth attachment";
        case Use::Clear:
            return "clear";
        case Use::Copy:
            return "copy";
    }
    return "";
}

std::string_view name(Layout layout) {
    switch (layout) {
        case Layout::Undefined:
            return "undefined";
        case Layout::General:
            return "general";
        case Layout::ShaderRead:
            return "shader read";
        case Layout::ColorAttachment:
            return "color attachment";
        case Layout::DepthAttachment:
            return "depth attachment";
        case Layout::TransferSource:
            return "transfer source";
        case Layout::TransferDestination:
            return "transfer destination";
    }
    return "";
}

}  // namespace nephrite::graph
