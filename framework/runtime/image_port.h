// The GLSL of one image port: its declaration and the functions the author's load, sample, store, ... become.
#pragma once

#include <cstdint>
#include <string>

#include "graph/plan.h"

namespace nephrite::runtime {

/// An image as one node sees it.
class ImagePort {
  public:
    /// `perIteration`: the node runs for each light and addresses the iteration's own layers.
    ImagePort(std::string name, const graph::Resource& resource, bool perIteration);

    // Declarations of set 1, one line each.
    std::string readonlyImage(std::uint32_t binding) const;
    std::string sampler(std::uint32_t binding) const;
    std::string writeonlyImage(std::uint32_t binding, std::uint32_t mip) const;
    std::string attachment(std::uint32_t location) const;

    /// load, loadLevel, loadLayer, extent, layers, levels, and sample, sampleLevel, sampleLayer unless it
    /// holds integers. `storage`: texels are read through readonlyImage(), else fetched through sampler().
    /// `filterable`: the device filters the format; otherwise four texels are mixed in the shader.
    std::string inputFunctions(bool storage, bool filterable) const;
    /// store, storeLevel, storeLayer, extent, layers, levels of an image written by compute.
    std::string outputFunctions() const;
    /// store and extent of a colour attachment; only extent of a depth attachment.
    std::string attachmentFunctions() const;

  private:
    std::string fill(std::string_view text) const;
    std::string layer(std::string_view index) const;

    std::string name_;
    const graph::Resource& resource_;
    bool perIteration_;
    std::string vector_;      ///< vec4 or uvec4
    std::string prefix_;      ///< "" or "u": image2D or uimage2D
    std::string array_;       ///< "" or "Array"
    std::string coordinate_;  ///< of a texel at p in `layer`
};

}  // namespace nephrite::runtime
