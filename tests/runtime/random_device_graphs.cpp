// See random_device_graphs.h. Every node reads only what is there before it, so there is no cycle; what a
// node overwrites is read by none that comes after it.
#include "runtime/random_device_graphs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <optional>

#include "graph/random_ports.h"
#include "runtime/random_device_passes.h"

namespace nephrite::runtime::test {
namespace {

using graph::ForEach;
using graph::Index;
using graph::noIndex;
using graph::PassKind;
using graph::PassType;
using graph::tests::Chance;
using graph::tests::PortSort;

/// A port that later nodes may read.
struct Port {
    std::string name;
    PortSort sort = PortSort::Float;
    std::uint32_t channels = 4;
    std::uint32_t mips = 1;
    std::uint32_t layers = 1;
    bool perLight = false;
    bool isOverwritten = false;
    bool isImport = false;
};

struct Node {
    const PassType* type = nullptr;
    std::string name;
    std::vector<std::pair<std::string, std::string>> inputs;
    std::vector<std::string> laterInputs;  ///< to be given an earlier frame's port when all nodes are there
    std::string rest;                      ///< its other members
};

constexpr std::array formats{"rgba32f", "rgba16f", "rgba8", "r32f"};

class Generator {
  public:
    Generator(std::uint64_t seed, const graph::PassLibrary& library)
        : chance_(seed), library_(library), names_(randomPassNames()) {}

    RandomDeviceGraph make() {
        result_.scene = chance_.below(static_cast<std::uint32_t>(std::size(lightViewsOfScene)));
        hasImport_ = chance_.oneIn(2);
        if (hasImport_) ports_.push_back({.name = "import(picture)", .isImport = true});
        const Index count = 6 + chance_.below(15);
        while (nodes_.size() < count) addNode();
        for (Node& node : nodes_) connectToThePast(node);
        if (chance_.oneIn(3)) shuffle();
        ask();
        result_.json = text();
        result_.settings = {"", "", ""};
        if (chance_.oneIn(2)) result_.settings[1] = fmt::format("shift={}", 0.01 * chance_.below(100));
        if (chance_.oneIn(4)) result_.settings[2] = "flag=0";
        return std::move(result_);
    }

  private:
    void addNode() {
        const PassType* type = library_.find(chance_.oneOf(names_));
        if (ports_.empty() || chance_.oneIn(10)) type = library_.find("noise");
        Node node;
        node.type = type;
        node.name = fmt::format("n{}", nodes_.size());
        std::vector<Port*> modified(type->inputs.size(), nullptr);
        for (Index i = 0; i < type->inputs.size(); ++i)
            if (!addInput(node, i, modified)) return;
        const std::vector<std::string> beside = partsBeside(node, modified);
        addOutputs(node, modified);
        addSettings(node);
        nodes_.push_back(std::move(node));
        for (const std::string& part : beside) addReader(part);
    }

    /// Levels and layers beside those that the node overwrites: they still hold what they did.
    std::vector<std::string> partsBeside(const Node& node, const std::vector<Port*>& modified) {
        std::vector<std::string> parts;
        for (const auto& [name, source] : node.inputs) {
            const auto isIt = [&, &name = name](const graph::InputPort& input) { return input.name == name; };
            const auto input = std::find_if(node.type->inputs.begin(), node.type->inputs.end(), isIt);
            const Port* port = modified[static_cast<std::size_t>(input - node.type->inputs.begin())];
            if (port == nullptr || port->sort != PortSort::Float) continue;
            const bool byMip = port->mips > 1;
            const Index count = byMip ? port->mips : port->layers;
            for (Index k = 0; k < count && parts.size() < 2; ++k) {
                const std::string kind = byMip ? "mip" : "layer";
                const std::string own = fmt::format("{}({}, ", kind, port->name);
                if (source.find(own) == std::string::npos) break;
                if (source.find(fmt::format("{}{})", own, k)) == std::string::npos)
                    parts.push_back(fmt::format("{}{})", own, k));
            }
        }
        return parts;
    }

    void addReader(const std::string& part) {
        Node node;
        node.type = library_.find("blend");
        node.name = fmt::format("n{}", nodes_.size());
        node.inputs.emplace_back("a", part);
        addOutputs(node, {nullptr});
        addSettings(node);
        nodes_.push_back(std::move(node));
    }

    /// False if no port fits.
    bool addInput(Node& node, Index index, std::vector<Port*>& modified) {
        const graph::InputPort& input = node.type->inputs[index];
        const Index output = modifierOf(*node.type, index);
        if (output == noIndex && (input.name == "before" || (input.optional && chance_.oneIn(8)))) {
            if (input.optional) {
                node.laterInputs.push_back(input.name);
                return true;
            }
        }
        if (input.optional && chance_.oneIn(3)) return true;
        Port* port = findPort([&](const Port& one) { return fits(node, index, output, one); });
        if (port == nullptr) return input.optional;
        // What is overwritten is not read by the same node.
        if (std::find(modified.begin(), modified.end(), port) != modified.end()) return input.optional;
        const bool partly = node.type->forEach == ForEach::Nothing && node.type->domainInput != index;
        const bool onlyPart = output != noIndex && node.type->kind == PassKind::Raster;
        const std::string whole = port->name;
        const std::string part = partly ? partOf(*port, onlyPart) : whole;
        node.inputs.emplace_back(input.name, part);
        if (output != noIndex) {
            for (const auto& other : node.inputs)
                if (&other != &node.inputs.back() && other.second.find(whole) != std::string::npos)
                    return false;
            modified[index] = port;
        }
        return true;
    }

    static Index modifierOf(const PassType& type, Index input) {
        for (Index i = 0; i < type.outputs.size(); ++i)
            if (type.outputs[i].modifiedInput == input) return i;
        return noIndex;
    }

    static PortSort sortOf(const graph::InputPort& input) {
        if (!input.bufferElement.empty()) return PortSort::Buffer;
        return input.format ? PortSort::Uint : PortSort::Float;
    }

    bool fits(const Node& node, Index index, Index output, const Port& port) const {
        const PassType& type = *node.type;
        if (port.isOverwritten) return false;
        PortSort sort = sortOf(type.inputs[index]);
        if (output == noIndex) {
            if (type.domainInput == index && (port.channels != 4 || port.mips > 1 || port.layers > 1))
                return false;
            return port.sort == sort ||
                   (port.sort == PortSort::Depth && sort == PortSort::Float && type.domainInput != index);
        }
        if (port.isImport) return false;
        if (type.outputs[output].format == graph::Format::d32f) sort = PortSort::Depth;
        if (type.forEach == ForEach::Lights && !port.perLight) return false;
        if (type.forEach == ForEach::Mips && port.mips == 1) return false;
        if (type.outputs.size() > 1 && (port.layers > 1 || port.mips > 1)) return false;
        return port.sort == sort;
    }

    template<class Fits>
    Port* findPort(Fits fits) {
        const auto count = static_cast<Index>(ports_.size());
        for (int attempt = 0; count > 0 && attempt < 16; ++attempt) {
            const Index recent = count - 1 - chance_.below(std::min<Index>(count, 5));
            Port& port = ports_[chance_.oneIn(3) ? chance_.below(count) : recent];
            if (fits(port)) return &port;
        }
        return nullptr;
    }

    /// The port, or one level or layer of it. `always`: a single image.
    std::string partOf(const Port& port, bool always) {
        std::string name = port.name;
        if (port.mips > 1 && (always || chance_.oneIn(2)))
            name = fmt::format("mip({}, {})", name, chance_.below(port.mips));
        if (port.layers > 1 && (always || chance_.oneIn(2)))
            name = fmt::format("layer({}, {})", name, chance_.below(port.layers));
        return name;
    }

    void addOutputs(Node& node, const std::vector<Port*>& modified) {
        const PassType& type = *node.type;
        std::uint32_t mips = 1;
        const bool sized = std::none_of(type.outputs.begin(), type.outputs.end(), [](const auto& output) {
            return !output.modifies.empty() || output.size || !output.bufferElement.empty();
        });
        const bool manyLevels = type.forEach == ForEach::Mips;
        if (sized && (manyLevels || chance_.oneIn(2))) {
            const std::uint32_t width = 8 + chance_.below(41);
            const std::uint32_t height = 8 + chance_.below(41);
            node.rest += fmt::format(", \"size\": [{}, {}]", width, height);
            if (manyLevels) mips = static_cast<std::uint32_t>(std::bit_width(std::max(width, height)));
        }
        std::vector<Port> added;
        std::vector<std::string> chosen;
        for (const graph::OutputPort& output : type.outputs) {
            Port port;
            port.name = fmt::format("{}.{}", node.name, output.name);
            if (!output.modifies.empty()) {
                const std::string name = port.name;
                port = *modified[output.modifiedInput];
                port.name = name;
                port.perLight &= type.forEach == ForEach::Lights;
            } else {
                describe(output, port);
                port.mips = mips;
                port.perLight = type.forEach == ForEach::Lights;
                if (port.perLight) port.layers *= std::max(1U, lightViewsOfScene[result_.scene]);
                if (port.sort == PortSort::Float && type.kind != PassKind::Raster && chance_.oneIn(2)) {
                    const char* format = chance_.oneOf(formats);
                    chosen.push_back(fmt::format("\"{}\": \"{}\"", output.name, format));
                    port.channels = std::string_view(format).starts_with("rgba") ? 4 : 1;
                }
            }
            added.push_back(std::move(port));
        }
        if (!chosen.empty()) node.rest += fmt::format(", \"format\": {{{}}}", fmt::join(chosen, ", "));
        for (Port* port : modified)
            if (port != nullptr) port->isOverwritten = true;
        ports_.insert(ports_.end(), added.begin(), added.end());
    }

    static void describe(const graph::OutputPort& output, Port& port) {
        if (!output.bufferElement.empty())
            port.sort = PortSort::Buffer;
        else if (output.format == graph::Format::r32u)
            port.sort = PortSort::Uint;
        else if (output.format == graph::Format::d32f)
            port.sort = PortSort::Depth;
        port.layers = static_cast<std::uint32_t>(output.layers.literal().value_or(1));
    }

    void addSettings(Node& node) {
        const std::string seed =
            chance_.oneIn(4) ? std::string("\"$shift\"") : fmt::format("{}", 0.01 * chance_.below(100));
        const char* amount = chance_.oneIn(4) ? "0" : "0.75";
        node.rest += fmt::format(R"(, "set": {{"seed": {}, "amount": {}}})", seed, amount);
        if (chance_.oneIn(10)) node.rest += R"(, "when": "$flag == 1")";
        if (node.type->name == "lightView") node.rest += R"(, "view": "light")";
    }

    /// An input that was left open reads an earlier frame.
    void connectToThePast(Node& node) {
        for (const std::string& input : node.laterInputs) {
            const Port* port = findPort([](const Port& one) {
                return !one.isOverwritten && !one.isImport && one.sort == PortSort::Float;
            });
            if (port == nullptr) continue;
            const std::string part = partOf(*port, false);
            node.inputs.emplace_back(input, chance_.oneIn(3) ? fmt::format("previous({}, 2)", part)
                                                             : fmt::format("previous({})", part));
        }
    }

    void shuffle() {
        for (Index i = static_cast<Index>(nodes_.size()); i > 1; --i)
            std::swap(nodes_[i - 1], nodes_[chance_.below(i)]);
    }

    /// What is looked at: the last port there is, some others as outputs, and some as dumps.
    void ask() {
        const auto isImage = [](const Port& port) {
            return !port.isOverwritten && port.sort != PortSort::Buffer && !port.isImport;
        };
        const auto last = std::find_if(ports_.rbegin(), ports_.rend(), isImage);
        if (last != ports_.rend()) outputs_.push_back(last->name);
        const Index outputs = 1 + chance_.below(4);
        for (Index i = 0; i < outputs; ++i)
            if (const Port* port = findPort(isImage)) outputs_.push_back(partOf(*port, false));
        for (Index i = chance_.below(3); i > 0; --i)
            if (const Port* port = findPort(isImage)) result_.dumps.push_back(partOf(*port, false));
        std::sort(result_.dumps.begin(), result_.dumps.end());
        result_.dumps.erase(std::unique(result_.dumps.begin(), result_.dumps.end()), result_.dumps.end());
    }

    std::string text() const {
        std::string json = R"({ "name": "random",
  "parameters": {"shift": {"value": 0.5}, "flag": {"value": 1}},
)";
        if (hasImport_) json += "  \"imports\": {\"picture\": {\"image\": \"picture.exr\"}},\n";
        json += "  \"nodes\": {\n";
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            json += fmt::format("    {}{}\n", textOf(nodes_[i]), i + 1 == nodes_.size() ? "}," : ",");
        json += "  \"outputs\": {";
        for (std::size_t i = 0; i < outputs_.size(); ++i)
            json += fmt::format("{}\"out{}\": \"{}\"", i == 0 ? "" : ", ", i, outputs_[i]);
        return json + "} }\n";
    }

    static std::string textOf(const Node& node) {
        std::string inputs;
        for (const auto& [name, source] : node.inputs)
            inputs += fmt::format("{}\"{}\": \"{}\"", inputs.empty() ? "" : ", ", name, source);
        return fmt::format(R"("{}": {{"pass": "{}", "in": {{{}}}{}}})", node.name, node.type->name, inputs,
                           node.rest);
    }

    Chance chance_;
    const graph::PassLibrary& library_;
    std::vector<std::string> names_;
    bool hasImport_ = false;
    std::vector<Port> ports_;
    std::vector<Node> nodes_;
    std::vector<std::string> outputs_;
    RandomDeviceGraph result_;
};

}  // namespace

RandomDeviceGraph randomDeviceGraph(std::uint64_t seed, const graph::PassLibrary& library) {
    return Generator(seed, library).make();
}

}  // namespace nephrite::runtime::test
