// See random_nodes.h.
#include "graph/random_nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "graph/small_library.h"

namespace nephrite::graph::tests {
namespace {

constexpr std::array floatFormats{Format::rgba16f, Format::rgba32f, Format::r8, Format::rg16f,
                                  Format::r11g11b10f};

bool isRaster(const PassType& type) {
    return type.kind == PassKind::Raster;
}

}  // namespace

std::uint32_t mostMips(Extent extent) {
    return static_cast<std::uint32_t>(std::bit_width(std::max(extent.width, extent.height)));
}

RandomNodes::RandomNodes(Chance& chance, std::uint32_t lightViews)
    : chance_(chance), lightViews_(lightViews) {
    description.name = "random";
    description.file = "random.json";
    GraphParameter flag;
    flag.name = "flag";
    flag.value.components = {chance.oneIn(2) ? 1.0 : 0.0};
    description.parameters.push_back(flag);
}

void RandomNodes::addImport(const ImportedImage& image) {
    GraphImport import;
    import.name = fmt::format("{}", description.imports.size());
    import.format = chance_.oneOf(floatFormats);
    RandomPort port;
    port.nodeName = fmt::format("import({})", import.name);
    port.portName = "image";
    port.format = import.format;
    port.extent = image.extent;
    port.mips = image.mips;
    port.layers = image.layers;
    port.isAskedFor = true;
    ports_.push_back(port);
    description.imports.push_back(std::move(import));
}

void RandomNodes::add() {
    Draft draft;
    draft.node.name = fmt::format("n{}", description.nodes.size());
    draft.node.passType = draft.type.name = fmt::format("t{}", description.nodes.size());
    chooseKind(draft);
    if (chance_.oneIn(3)) addModifier(draft);
    const bool isPlain = draft.type.inputs.empty() && draft.forEach == ForEach::Nothing;
    if (isPlain && draft.type.kind == PassKind::Pixel && !chance_.oneIn(3)) addDomain(draft);
    addInputs(draft);
    addOutputs(draft);
    addConditions(draft);
    finish(draft);
}

void RandomNodes::chooseKind(Draft& draft) {
    static constexpr std::array kinds{PassKind::Pixel, PassKind::Compute, PassKind::Raster, PassKind::Native};
    draft.type.kind = chance_.oneOf(kinds);
    if (chance_.oneIn(4)) {
        draft.forEach = ForEach::Lights;
        if (chance_.oneIn(2)) draft.node.view = ViewKind::Light;
    } else if (!isRaster(draft.type) && chance_.oneIn(6)) {
        draft.forEach = ForEach::Mips;
    }
    if (draft.forEach == ForEach::Mips || chance_.oneIn(3))
        draft.extent = Extent{2 + chance_.below(60), 2 + chance_.below(60)};
    // Half of them by the pass type, half by the node.
    if (draft.forEach != ForEach::Nothing) {
        if (chance_.oneIn(2)) {
            draft.type.forEach = draft.forEach;
        } else {
            draft.node.forEach = draft.forEach;
        }
    }
}

/// Mostly a port of a node added lately, so that graphs are deep and not only wide. Null if there is none.
RandomPort* RandomNodes::randomReadable() {
    const auto count = static_cast<Index>(ports_.size());
    for (int attempt = 0; count > 0 && attempt < 8; ++attempt) {
        RandomPort& port = ports_[chance_.oneIn(3) ? chance_.below(count)
                                                   : count - 1 - chance_.below(std::min<Index>(count, 4))];
        if (!port.isOverwritten) return &port;
    }
    return nullptr;
}

void RandomNodes::addInput(Draft& draft, RandomPort& port, PortReference from) {
    InputPort input;
    input.name = fmt::format("in{}", draft.type.inputs.size());
    input.optional = true;
    expect(input, port);
    draft.node.inputs.emplace_back(input.name, std::move(from));
    draft.type.inputs.push_back(std::move(input));
}

void RandomNodes::addInputs(Draft& draft) {
    for (Index i = chance_.below(4); i > 0; --i) {
        RandomPort* port = randomReadable();
        if (port == nullptr || chance_.oneIn(8)) {
            InputPort unconnected;
            unconnected.name = fmt::format("in{}", draft.type.inputs.size());
            unconnected.optional = true;
            draft.type.inputs.push_back(unconnected);
        } else {
            addInput(draft, *port, reference(*port, chance_));
        }
        if (chance_.oneIn(4)) draft.type.inputs.back().neededWhen = randomCondition(draft.type);
    }
}

bool RandomNodes::canModify(const Draft& draft, const RandomPort& port) const {
    if (port.isOverwritten || port.isAskedFor) return false;
    if (isRaster(draft.type) ? port.sort == PortSort::Uint || port.sort == PortSort::Buffer
                             : port.sort == PortSort::Depth)
        return false;
    if (isRaster(draft.type) && port.mips > 1 && draft.forEach != ForEach::Nothing) return false;
    if (draft.forEach == ForEach::Lights) return port.perLight;
    return draft.forEach == ForEach::Nothing || (port.mips > 1 && port.sort != PortSort::Buffer);
}

void RandomNodes::addModifier(Draft& draft) {
    RandomPort* port = randomReadable();
    if (port == nullptr || !canModify(draft, *port)) return;
    PortReference from = reference(*port, chance_);
    if (draft.forEach == ForEach::Mips) from.mip.reset();
    if (draft.forEach == ForEach::Lights) from.layer.reset();
    // A draw goes to one level.
    if (isRaster(draft.type) && port->mips > 1 && !from.mip) from.mip = chance_.below(port->mips);
    if (isRaster(draft.type) && port->layers > 1 && draft.forEach == ForEach::Nothing && !from.layer)
        from.layer = chance_.below(port->layers);
    OutputPort output;
    output.name = "out0";
    output.modifies = "in0";
    output.modifiedInput = 0;
    output.format = port->format;
    if (port->sort == PortSort::Buffer) output.bufferElement = "vec4";
    RandomPort written = *port;
    written.node = static_cast<Index>(description.nodes.size());
    written.nodeName = draft.node.name;
    written.portName = output.name;
    written.perLight = draft.forEach == ForEach::Lights;
    addInput(draft, *port, from);
    draft.type.inputs.back().optional = false;
    draft.type.outputs.push_back(output);
    draft.outputs.push_back(written);
    port->isOverwritten = true;
    // It may read another level of what it modifies.
    if (from.mip && port->mips > 1 && chance_.oneIn(2)) {
        from.mip = (*from.mip + 1) % port->mips;
        addInput(draft, *port, from);
    }
}

/// Makes the first input the domain, of which every output has the size.
void RandomNodes::addDomain(Draft& draft) {
    RandomPort* port = randomReadable();
    if (port == nullptr || port->sort != PortSort::Float || port->mips > 1 || port->layers > 1) return;
    PortReference from;
    from.node = port->nodeName;
    from.port = port->portName;
    addInput(draft, *port, from);
    draft.type.inputs[0].optional = false;
    draft.type.domain = "in0";
    draft.type.domainInput = 0;
    draft.extent.reset();
}

void RandomNodes::addOutputs(Draft& draft) {
    const bool drawsOver =
        (isRaster(draft.type) || draft.forEach == ForEach::Mips) && !draft.type.outputs.empty();
    draft.type.sideEffect = chance_.oneIn(12);
    const bool mayBeEmpty = !draft.type.outputs.empty() || (draft.type.sideEffect && !isRaster(draft.type) &&
                                                            draft.forEach != ForEach::Mips);
    const Index count = drawsOver ? 0 : (mayBeEmpty ? 0 : 1) + chance_.below(3);
    for (Index i = 0; i < count; ++i) {
        OutputPort output;
        output.name = fmt::format("out{}", draft.type.outputs.size());
        RandomPort port = randomOutput(draft, output);
        if (isRaster(draft.type) && i + 1 == count && chance_.oneIn(2)) {
            output.format = port.format = Format::d32f;
            port.sort = PortSort::Depth;
        }
        draft.outputs.push_back(port);
        draft.type.outputs.push_back(std::move(output));
    }
    if (!draft.extent) return;
    SizeRule size;
    size.kind = SizeRule::Kind::Absolute;
    size.width = Expression::constant(draft.extent->width);
    size.height = Expression::constant(draft.extent->height);
    draft.node.size = size;
}

RandomPort RandomNodes::randomOutput(Draft& draft, OutputPort& output) {
    RandomPort port;
    port.node = static_cast<Index>(description.nodes.size());
    port.nodeName = draft.node.name;
    port.portName = output.name;
    port.extent = draft.extent.value_or(Extent{});
    const bool isPlain = !isRaster(draft.type) && draft.type.domain.empty();
    if (isPlain && draft.forEach != ForEach::Mips && chance_.oneIn(5)) {
        port.sort = PortSort::Buffer;
        output.bufferElement = "vec4";
        output.bufferCount = Expression::constant(chance_.below(4));
        return port;
    }
    output.format = port.format = chance_.oneOf(floatFormats);
    if (isPlain && chance_.oneIn(8)) {
        output.format = port.format = Format::r32u;
        port.sort = PortSort::Uint;
    }
    if (isPlain && draft.extent && (draft.forEach == ForEach::Mips || chance_.oneIn(2))) {
        port.mips = mostMips(*draft.extent);
        output.mips = Expression::constant(0);
    }
    if (isPlain && chance_.oneIn(4)) {
        port.layersPerIteration = 1 + chance_.below(3);
        output.layers = Expression::constant(port.layersPerIteration);
    }
    port.perLight = draft.forEach == ForEach::Lights;
    port.layers = port.layersPerIteration * (port.perLight ? std::max(1U, lightViews_) : 1);
    if (!draft.type.domain.empty()) {
        SizeRule like;
        like.kind = SizeRule::Kind::Like;
        like.like = "in0";
        output.size = like;
    }
    return port;
}

std::optional<Expression> RandomNodes::randomCondition(const PassType& type) {
    switch (chance_.below(type.inputs.empty() ? 4 : 5)) {
        case 0:
            return Expression::constant(0);
        case 1:
            return Expression::constant(1);
        case 2:
            return expression("scene.translucentMaterials == 0");
        case 3:
            return expression("scene.pointLights > 5 || scene.animated == 0");
        default:
            return expression("inputs.in0.neutral");
    }
}

void RandomNodes::addConditions(Draft& draft) {
    if (chance_.oneIn(6)) draft.type.skipWhen = randomCondition(draft.type);
    if (chance_.oneIn(10)) draft.node.when = expression("graph.flag == 1");
    if (chance_.oneIn(20)) draft.node.when = Expression::constant(0);
}

void RandomNodes::finish(Draft& draft) {
    ports_.insert(ports_.end(), draft.outputs.begin(), draft.outputs.end());
    description.nodes.push_back(std::move(draft.node));
    types.push_back(std::move(draft.type));
}

void RandomNodes::addPrevious(std::uint32_t framesBack) {
    RandomPort* port = randomReadable();
    if (port == nullptr || port->node == noIndex) return;
    port->isAskedFor = true;
    const std::size_t reader = chance_.below(static_cast<std::uint32_t>(types.size()));
    PassType& type = types[reader];
    if (type.outputs.empty() && !type.sideEffect) return;
    InputPort input;
    input.name = fmt::format("in{}", type.inputs.size());
    input.optional = true;
    expect(input, *port);
    PortReference from = reference(*port, chance_);
    from.framesBack = framesBack;
    description.nodes[reader].inputs.emplace_back(input.name, from);
    type.inputs.push_back(std::move(input));
}

PortReference RandomNodes::askFor() {
    RandomPort* port = nullptr;
    while (port == nullptr) {
        if (std::all_of(ports_.begin(), ports_.end(), [](const auto& one) { return one.isOverwritten; }))
            add();
        port = randomReadable();
    }
    port->isAskedFor = true;
    return reference(*port, chance_);
}

}  // namespace nephrite::graph::tests
