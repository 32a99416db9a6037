// Linked graph + numbers -> plan. The phases are one file each under graph/compiler/.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "graph/plan.h"

namespace nephrite::graph {

/// What a scene tells the compiler: the facts expressions may name (scene.FACT) and how many views its lights
/// have.
struct SceneFacts {
    std::uint32_t translucentMaterials = 0;
    std::uint32_t opaqueMaterials = 0;
    std::uint32_t pointLights = 0;
    std::uint32_t environment = 0;  ///< 1 if the environment has radiance
    std::uint32_t maxLayers = 0;
    std::uint32_t layerTextures = 0;
    std::uint32_t animated = 0;
    std::uint32_t objects = 0;
    std::uint32_t lightViews =
        0;  ///< forEach iterations: 1 a light, 6 for a light inside the scene's bounding sphere

    /// The value of scene.NAME, or nothing if there is no such fact.
    std::optional<double> find(std::string_view name) const;
    static std::vector<std::string_view> names();
};

struct CompileRequest {
    std::shared_ptr<const LinkedGraph> graph;
    SceneFacts facts;
    Extent view;                       ///< the output's size
    std::vector<PortReference> dumps;  ///< ports wanted beside the graph's outputs
    InputReads inputReads = InputReads::StorageImage;
    bool skip = true;                 ///< false: --no-skip
    std::uint32_t maxExtent = 16384;  ///< of an image side on the device
    std::uint32_t maxLayers = 2048;
};

/// Throws InputError: sizes that are negative, zero, absurd or not numbers, an unknown dump.
Plan compile(const CompileRequest& request);

}  // namespace nephrite::graph
