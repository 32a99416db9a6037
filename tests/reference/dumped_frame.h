// One frame of graphs/paper.json, rendered in this process, with every image it made.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "reference/literal/texels.h"
#include "runtime/session.h"

namespace nephrite::reference {

/// In what formats the graph's images are: as the manifests say, or all of them rgba32f.
enum class Formats : std::uint8_t { Default, AllFloat32 };

struct FrameRequest {
    std::filesystem::path scene;
    graph::Extent size{128, 128};
    Formats formats = Formats::AllFloat32;
    std::vector<std::string> settings;  ///< as runtime::SessionOptions
};

class DumpedFrame {
  public:
    /// Renders one frame at time 0 and keeps every image of every node but the depth buffers.
    explicit DumpedFrame(const FrameRequest& request);

    /// One array layer of "node.port".
    Texels texels(const std::string& port, std::uint32_t layer = 0) const;
    const image::Image& image(const std::string& port) const { return images_.at(port); }
    const std::map<std::string, image::Image>& images() const { return images_; }

    /// The components of a parameter of a node that ran.
    const std::vector<double>& parameter(const std::string& node, const std::string& name) const;
    graph::Format format(const std::string& port) const { return formats_.at(port); }

  private:
    std::map<std::string, image::Image> images_;
    std::map<std::string, graph::Format> formats_;
    std::map<std::string, std::vector<double>> parameters_;  ///< by "node.parameter"
};

/// The project's folder `graphs`.
std::filesystem::path graphFolder();

}  // namespace nephrite::reference
