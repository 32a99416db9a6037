// What a draft holds; Session takes it over.
#pragma once

#include "runtime/draft.h"
#include "runtime/planning/planning.h"
#include "scene/scene.h"

namespace nephrite::runtime {

struct Draft::State {
    DraftRequest request;
    const gpu::Device& device;
    graph::InputReads reads;
    SessionOptions options;  ///< the session's when the draft was begun
    DataFolders folders;
    GraphContent content;                       ///< the session's, until another is read
    std::shared_ptr<const scene::Scene> scene;  ///< the same
    ProgramCache programs;
    DraftTimes times;
    std::filesystem::file_time_type readAt;  ///< when it was begun, or build() was
    std::uint64_t graphsSeen = 0;            ///< by the session when the draft was begun
    std::vector<std::string> changesSeen;    ///< the same, of values

    PlanningContext planning() const { return {device, reads, options}; }
};

/// Every file that these were made from, absolute.
std::vector<std::filesystem::path> filesOf(const GraphContent& content, const scene::Scene& scene,
                                           const ProgramCache& programs);

}  // namespace nephrite::runtime
