// Linked graph + numbers -> plan. The phases are one file each under graph/compiler/.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "graph/plan.h"

namespace nephrite::graph {

/// What a scene tells the compiler: the facts expressions may name (scene.FACT).
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

/// Parts of a scene that a pass can depend on, as bits.
enum class ScenePart : std::uint8_t { Camera, Lights, Geometry, Materials, Environment, Time };
using SceneParts = std::uint32_t;
constexpr SceneParts bit(ScenePart part) {
    return SceneParts{1} << static_cast<unsigned>(part);
}

/// Which results outlast the frame, so that their passes need not run again while nothing they read changes.
/// Kept results do not share memory.
enum class Keep : std::uint8_t {
    Nothing,
    AcrossRates,  ///< results that change less often than a pass that reads them, and the requested outputs
    Everything,
};

/// An image from outside, as it arrives and as its owner wants it back.
struct ImportedImage {
    Extent extent{};
    std::uint32_t mips = 1;
    std::uint32_t layers = 1;
    Layout initial = Layout::ShaderRead;
    std::uint32_t usesBefore = 0;      ///< bits (1 << Use) that may still be under way when the frame starts
    Layout final = Layout::Undefined;  ///< Undefined: as its last use leaves it
};

/// What a resource takes in the heap.
struct MemoryNeed {
    std::uint64_t bytes = 0;
    std::uint64_t alignment = 1;  ///< a power of two
};

struct CompileRequest {
    std::shared_ptr<const LinkedGraph> graph;
    SceneFacts facts;
    Extent view;                       ///< the output's size
    std::vector<PortReference> dumps;  ///< ports wanted beside the graph's outputs
    InputReads inputReads = InputReads::StorageImage;
    bool skip = true;  ///< false: --no-skip
    Policy policy = Policy::Barriers;
    Keep keep = Keep::Nothing;
    bool plain =
        false;  ///< in the order of declaration, and nothing shares memory: what other plans are held against
    std::vector<SceneParts>
        dependsOn;  ///< by node: what its shader reads of the scene; empty: nothing is known
    std::vector<ImportedImage> imports;                 ///< as description.imports
    std::shared_ptr<const ParameterValues> parameters;  ///< null: as the graph says
    /// What a resource needs; empty: its packed size, at multiples of 256 bytes.
    std::function<MemoryNeed(const Resource&)> memory;
    std::uint32_t maxExtent = 16384;  ///< of an image side on the device
    std::uint32_t maxLayers = 2048;
};

/// Throws InputError: sizes that are negative, zero, absurd or not numbers, an unknown dump, a level or layer
/// that an image does not have, an import without an image.
Plan compile(const CompileRequest& request);

}  // namespace nephrite::graph
