// The generated half of a pass's shader: GLSL declarations of a node's ports and parameters, made from its
// manifest and plan, and the list of descriptors that go with them. Shader and graph cannot disagree because
// both come from here.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "graph/plan.h"

namespace nephrite::runtime {

/// One descriptor of set 1.
struct PortDescriptor {
    enum class Kind : std::uint8_t { ParameterBlock, StorageImage, SampledImage, StorageBuffer };
    /// Which level, where the pass runs once a level. Images that a dispatch does not use must not be bound
    /// to it.
    enum class Level : std::uint8_t {
        Fixed,      ///< `mip`
        Iteration,  ///< the one the iteration writes
        Above,      ///< `mip`, at most the one before the iteration's
    };
    Kind kind = Kind::StorageImage;
    std::uint32_t binding = 0;
    graph::Index resource = graph::noIndex;  ///< none for the parameter block
    std::uint16_t mip = graph::every;        ///< the level it shows; a storage image always shows one
    std::uint16_t layer = graph::every;      ///< the array layer it shows
    Level level = Level::Fixed;
};

/// A parameter component that is a specialization constant; its id is its index in
/// NodeInterface::specialization.
struct SpecializedWord {
    std::uint32_t value = 0;  ///< bits as the shader's type has them
    friend bool operator==(const SpecializedWord&, const SpecializedWord&) = default;
};

/// What a node's shader is compiled with.
struct NodeInterface {
    std::string declarations;  ///< GLSL before the author's file
    std::string entryPoint;    ///< GLSL after it
    std::vector<PortDescriptor> descriptors;
    std::vector<SpecializedWord> specialization;
    std::vector<std::uint32_t> parameterWords;  ///< contents of the parameter block, padded to whole vec4
};

/// True if images of a format can be filtered linearly on the device.
using Filterable = std::function<bool(graph::Format)>;

/// The interface of one pass of a plan with these parameter values, which decide only `specialization` and
/// `parameterWords`.
NodeInterface nodeInterface(const graph::Plan& plan, const graph::PlannedPass& pass,
                            const graph::ParameterValues& values, const Filterable& filterable);

/// The tile list of a pass over tiles has one entry of indirect arguments (16 bytes each) for each layer of
/// its domain.
std::uint32_t tileListLayers(const graph::Plan& plan, const graph::PlannedPass& pass);
/// The layer of the domain whose tiles an iteration computes.
std::uint32_t tileLayer(const graph::Plan& plan, const graph::PlannedPass& pass, std::uint32_t iteration);

/// Rewrites `load(PORT, ...)` and its kin to the generated function of that port, `load_PORT(...)`, line by
/// line in place: GLSL has neither opaque values to pass a port by nor macros with a varying number of
/// arguments.
class PortCalls {
  public:
    explicit PortCalls(const graph::PassType& type);
    std::string rewrite(std::string_view source) const;

  private:
    std::vector<std::string> ports_;  ///< sorted
};

}  // namespace nephrite::runtime
