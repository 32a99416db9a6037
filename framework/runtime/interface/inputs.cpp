// A node's input ports in GLSL.
#include <fmt/format.h>

#include "runtime/interface/draft.h"
#include "runtime/interface/glsl_template.h"

namespace nephrite::runtime {
namespace {

// An input without a source, or whose source is skipped.
constexpr std::string_view neutralInput = R"(
const @VECTOR@ neutral_@NAME@ = @VECTOR@(@VALUE@);
ivec2 extent_@NAME@() { return ivec2(@WIDTH@, @HEIGHT@); }
int layers_@NAME@() { return 1; }
int levels_@NAME@() { return 1; }
@VECTOR@ load_@NAME@(ivec2 p) { return neutral_@NAME@; }
@VECTOR@ load_@NAME@(ivec2 p, int level) { return neutral_@NAME@; }
@VECTOR@ loadLevel_@NAME@(ivec2 p, int level) { return neutral_@NAME@; }
@VECTOR@ loadLayer_@NAME@(ivec2 p, int layer) { return neutral_@NAME@; }
@VECTOR@ loadLayer_@NAME@(ivec2 p, int layer, int level) { return neutral_@NAME@; }
@VECTOR@ sample_@NAME@(vec2 uv) { return neutral_@NAME@; }
@VECTOR@ sampleLevel_@NAME@(vec2 uv, float level) { return neutral_@NAME@; }
@VECTOR@ sampleLayer_@NAME@(vec2 uv, int layer) { return neutral_@NAME@; }
)";

std::string floatLiteral(double value) {
    return fmt::format("{:.9e}", static_cast<float>(value));
}

/// The output that modifies an input, or none.
graph::Index modifierOf(const graph::PassType& type, graph::Index input) {
    for (graph::Index port = 0; port < type.outputs.size(); ++port)
        if (type.outputs[port].modifiedInput == input) return port;
    return graph::noIndex;
}

void addModifiedInput(InterfaceDraft& draft, const graph::InputPort& port, graph::Index modifier) {
    const std::string& written = draft.type().outputs[modifier].name;
    if (draft.plan().resources[draft.output(modifier)].isBuffer)
        return draft.addLine(fmt::format("#define {} {}", port.name, written));
    PortImage image = draft.imageOfOutput(modifier);
    if (draft.isOverMips()) image.mips = 1;  // the level at hand
    draft.add(ImagePort(port.name, image, draft.isOverLights()).modifiedInputFunctions(written));
}

void addNeutralImage(InterfaceDraft& draft, const graph::InputPort& port, graph::Index index) {
    const bool isInteger = port.format && graph::info(*port.format).isUnsignedInteger;
    const auto v = neutralOf(draft.plan(), draft.pass(), index);
    const graph::Extent extent = draft.read(index).extent;
    const std::string width = draft.block().append(extent.width, "int");
    const std::string height = draft.block().append(extent.height, "int");
    draft.add(
        fillIn(neutralInput, {{"NAME", port.name},
                              {"VECTOR", isInteger ? "uvec4" : "vec4"},
                              {"VALUE", fmt::format("{}, {}, {}, {}", floatLiteral(v[0]), floatLiteral(v[1]),
                                                    floatLiteral(v[2]), floatLiteral(v[3]))},
                              {"WIDTH", width},
                              {"HEIGHT", height}}));
}

void addNeutralBuffer(InterfaceDraft& draft, const graph::InputPort& port) {
    draft.addLine(fmt::format("{0} {1}[1] = {0}[1]({0}(0));", port.bufferElement, port.name));
}

void addImage(InterfaceDraft& draft, const std::string& name, const graph::InputRead& read,
              const Filterable& filterable) {
    using Kind = PortDescriptor::Kind;
    const graph::Resource& resource = draft.plan().resources[read.resource];
    const PortImage image = PortImage::of(resource, read.mip, read.layer);
    const ImagePort port(name, image, read.perIteration);
    const bool storage = draft.plan().inputReads == graph::InputReads::StorageImage &&
                         !graph::info(resource.format).isDepth && image.mips == 1;
    const std::uint16_t level = read.mip == graph::every ? 0 : read.mip;
    if (storage)
        draft.add(
            port.readonlyImage(draft.addDescriptor(Kind::StorageImage, read.resource, level, read.layer)));
    draft.add(port.sampler(draft.addDescriptor(Kind::SampledImage, read.resource, read.mip, read.layer)));
    draft.add(port.inputFunctions(storage, filterable(resource.format)));
    if (draft.plan().graph->nodes[draft.pass().node].role == graph::NodeRole::TileList)
        draft.addLine(
            fmt::format("const int domainChannel = {};", graph::info(resource.format).channels - 1));
}

}  // namespace

void addInput(InterfaceDraft& draft, graph::Index index, const Filterable& filterable) {
    const graph::InputPort& port = draft.type().inputs[index];
    const graph::InputRead& read = draft.read(index);
    const bool connected = read.resource != graph::noIndex;
    draft.addLine(fmt::format("bool connected_{}() {{ return {}; }}", port.name, connected));
    const graph::Index modifier = modifierOf(draft.type(), index);
    if (modifier != graph::noIndex && !draft.isRaster()) return addModifiedInput(draft, port, modifier);
    if (connected && !read.modified) {
        if (!draft.plan().resources[read.resource].isBuffer)
            return addImage(draft, port.name, read, filterable);
        return draft.addBuffer(port.name, port.bufferElement, read.resource, "readonly ");
    }
    if (port.bufferElement.empty()) return addNeutralImage(draft, port, index);
    addNeutralBuffer(draft, port);
}

}  // namespace nephrite::runtime
