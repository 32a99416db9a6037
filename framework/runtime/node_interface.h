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
    Kind kind = Kind::StorageImage;
    std::uint32_t binding = 0;
    graph::Index resource = graph::noIndex;  ///< none for the parameter block
    std::uint32_t mip = 0;                   ///< a storage image shows one level, a sampled image every one
};

/// A parameter component that is a specialization constant; its id is its index in
/// NodeInterface::specialization.
struct SpecializedWord {
    std::uint32_t value = 0;  ///< bits as the shader's type has them
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

/// The interface of one pass of a plan.
NodeInterface nodeInterface(const graph::Plan& plan, const graph::PlannedPass& pass,
                            const Filterable& filterable);

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
