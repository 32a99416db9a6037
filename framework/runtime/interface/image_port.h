// The GLSL of one image port: its declaration and the functions the author's load, sample, store, ... become.
#pragma once

#include <cstdint>
#include <string>

#include "graph/plan.h"

namespace nephrite::runtime {

/// The part of an image that a port shows.
struct PortImage {
    graph::Format format = graph::Format::rgba16f;
    std::uint32_t mips = 1;
    std::uint32_t layers = 1;
    std::uint32_t layersPerIteration = 1;

    /// `mip` and `layer`: the only ones it shows, or graph::every.
    static PortImage of(const graph::Resource& resource, std::uint16_t mip = graph::every,
                        std::uint16_t layer = graph::every);
};

/// What a compute pass does with an image it writes.
enum class OutputAccess : std::uint8_t {
    Write,
    Modify,  ///< loads and stores any texel
    Mips,    ///< an iteration stores to its level and may load the levels above it
};

/// An image as one node sees it.
class ImagePort {
  public:
    /// `perIteration`: the node runs for each light and addresses the iteration's own layers.
    ImagePort(std::string name, const PortImage& image, bool perIteration);

    // Declarations of set 1, one line each.
    std::string readonlyImage(std::uint32_t binding) const;
    std::string sampler(std::uint32_t binding) const;
    std::string outputImage(std::uint32_t binding, std::uint32_t mip, OutputAccess access) const;
    std::string levelAbove(std::uint32_t binding, std::uint32_t mip) const;
    std::string attachment(std::uint32_t location) const;

    /// load, loadLevel, loadLayer, extent, layers, levels, and sample, sampleLevel, sampleLayer unless it
    /// holds integers. `storage`: texels are read through readonlyImage(), else fetched through sampler().
    /// `filterable`: the device filters the format; otherwise four texels are mixed in the shader.
    std::string inputFunctions(bool storage, bool filterable) const;
    /// store, storeLevel, storeLayer, extent, layers, levels of an image written by compute; with Mips also
    /// load and loadLevel of the levels above the iteration's own.
    std::string outputFunctions(OutputAccess access) const;
    /// The functions of an input that the output `output` modifies: they read what it writes.
    std::string modifiedInputFunctions(const std::string& output) const;
    /// store and extent of a colour attachment; only extent of a depth attachment.
    std::string attachmentFunctions() const;

  private:
    std::string fill(std::string_view text, const std::string& output) const;
    std::string fill(std::string_view text) const { return fill(text, name_); }
    std::string fetchCase(std::uint32_t level, const std::string& image) const;
    std::string layer(std::string_view index) const;

    std::string name_;
    PortImage image_;
    bool perIteration_;
    std::string vector_;      ///< vec4 or uvec4
    std::string prefix_;      ///< "" or "u": image2D or uimage2D
    std::string array_;       ///< "" or "Array"
    std::string coordinate_;  ///< of a texel at p in `layer`
};

}  // namespace nephrite::runtime
