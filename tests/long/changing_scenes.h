// Scenes and graphs between which a long run changes.
#pragma once

#include <string>
#include <vector>

#include "runtime/session.h"
#include "scratch_folder.h"

namespace nephrite::runtime::test {

/// A graph as a session starts it, and settings that may change it from frame to frame.
struct ChangingGraph {
    GraphSource source;
    std::vector<std::string> changes;
};

/// A scene and graphs that fit it.
struct ChangingScene {
    std::filesystem::path file;
    std::vector<ChangingGraph> graphs;
};

/// Shipped scenes, each with the paper's pipeline and a running mean over frames, and small ones, each with
/// graphs of random passes. Writes what they need into the folder; pass types are in its folder `passes`.
std::vector<ChangingScene> changingScenes(const ScratchFolder& folder);

/// A graph whose plan can be made but whose shader cannot be compiled.
std::filesystem::path writeBrokenGraph(const ScratchFolder& folder);

}  // namespace nephrite::runtime::test
