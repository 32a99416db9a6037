// One frame of graphs/paper.json, rendered in this process, with every image it made.
#include "reference/dumped_frame.h"

#include <fmt/format.h>
#include <json/writer.h>

#include <stdexcept>

#include "graph/format.h"
#include "runtime/loading/data_folders.h"
#include "runtime/loading/graph_loading.h"
#include "scratch_folder.h"
#include "text/json.h"

namespace nephrite::reference {
namespace {

/// Every port of every node of a graph but the depth buffers, as "node.port".
std::vector<std::string> colourPorts(const graph::LinkedGraph& graph) {
    std::vector<std::string> ports;
    for (std::size_t node = 0; node < graph.nodes.size(); ++node) {
        if (graph.nodes[node].role != graph::NodeRole::Pass) continue;
        for (const graph::OutputPort& port : graph.nodes[node].type->outputs) {
            if (!graph::info(port.format).isDepth)
                ports.push_back(graph.description.nodes[node].name + "." + port.name);
        }
    }
    return ports;
}

/// A copy of the graph in which each of `ports` has the format rgba32f.
std::filesystem::path inFloat32(const std::filesystem::path& graph, const std::vector<std::string>& ports) {
    Json::Value root = json::parseFile(graph).raw();
    for (const std::string& port : ports) {
        const std::size_t dot = port.find('.');
        root["nodes"][port.substr(0, dot)]["format"][port.substr(dot + 1)] = "rgba32f";
    }
    return sharedScratchFolder().write("float32.json", Json::writeString(Json::StreamWriterBuilder(), root));
}

/// The first channel of an array layer: layer 0 is "R", others "layer1.R".
std::size_t channelOf(const image::Image& image, std::uint32_t layer, char letter) {
    const std::string name = layer == 0 ? std::string(1, letter) : fmt::format("layer{}.{}", layer, letter);
    for (std::size_t channel = 0; channel < image.channels.size(); ++channel) {
        if (image.channels[channel] == name) return channel;
    }
    throw std::runtime_error("an image has no channel " + name);
}

}  // namespace

std::filesystem::path graphFolder() {
    return std::filesystem::path(NEPHRITE_SOURCE_DIR) / "graphs";
}

DumpedFrame::DumpedFrame(const FrameRequest& request) {
    sharedScratchFolder();
    runtime::SessionOptions options;
    options.graph = graphFolder() / "paper.json";
    options.scene = request.scene;
    options.size = request.size;
    options.settings = request.settings;
    const runtime::LoadedGraph loaded =
        runtime::loadGraph(options.graph, {}, runtime::DataFolders::find(), {});
    options.dumps = colourPorts(*loaded.graph);
    if (request.formats == Formats::AllFloat32) options.graph = inFloat32(options.graph, options.dumps);

    runtime::Session session(options);
    session.renderFrame(0);
    for (const std::string& port : options.dumps) images_.emplace(port, session.read(port));
    images_.emplace("color", session.read("color"));
    const graph::Plan& plan = session.plan();
    for (const graph::Resource& resource : plan.resources)
        formats_.emplace(plan.nameOf(resource), resource.format);
    for (const graph::PlannedPass& pass : plan.passes) {
        const auto& declarations = plan.typeOf(pass).parameters;
        for (graph::Index i = 0; i < declarations.size(); ++i)
            parameters_.emplace(plan.nameOf(pass) + "." + declarations[i].name,
                                plan.graph->valueOf(pass.node, i, session.parameters()).components);
    }
}

Texels DumpedFrame::texels(const std::string& port, std::uint32_t layer) const {
    const image::Image& source = images_.at(port);
    std::array<std::size_t, 4> channel{};
    for (std::size_t i = 0; i < 4; ++i) channel[i] = channelOf(source, layer, "RGBA"[i]);
    const std::size_t count = std::size_t{source.width} * source.height;
    const std::size_t stride = source.channels.size();
    std::vector<glm::dvec4> values(count);
    for (std::size_t pixel = 0; pixel < count; ++pixel) {
        for (std::size_t i = 0; i < 4; ++i)
            values[pixel][static_cast<int>(i)] =
                static_cast<double>(source.pixels[pixel * stride + channel[i]]);
    }
    return {static_cast<int>(source.width), static_cast<int>(source.height), std::move(values)};
}

const std::vector<double>& DumpedFrame::parameter(const std::string& node, const std::string& name) const {
    return parameters_.at(node + "." + name);
}

}  // namespace nephrite::reference
