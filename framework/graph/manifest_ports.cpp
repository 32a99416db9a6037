// The inputs and outputs of a pass manifest.
#include "graph/manifest_ports.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graph/keys.h"
#include "graph/value_readers.h"

namespace nephrite::graph {
namespace {

void readDoc(json::ObjectReader& object, std::string& doc) {
    if (const auto value = object.optional("doc")) {
        doc = value->string(object.diagnostics(), "a string").value_or("");
    }
}

void readNeutral(json::ObjectReader& object, std::array<double, 4>& neutral) {
    const auto value = object.optional("neutral");
    if (!value) return;
    const auto numbers = value->numbers(object.diagnostics(), "a neutral value of 4 numbers", 4);
    if (!numbers) return;
    for (const double number : *numbers) {
        if (std::abs(number) <= largestNeutral) continue;
        object.diagnostics().error(
            value->where(),
            fmt::format("a neutral value is within -{0} and {0}, found {1}", largestNeutral, number));
        return;
    }
    std::copy(numbers->begin(), numbers->end(), neutral.begin());
}

std::string readBufferElement(json::ObjectReader& object) {
    const auto value = object.optional("buffer");
    if (!value) return {};
    const auto choice = readChoice(*value, bufferElements(), object.diagnostics());
    return choice ? std::string(bufferElements()[*choice]) : std::string();
}

/// Keys that describe an image mean nothing on a buffer.
void refuseImageKeys(const json::ObjectReader& object, std::span<const std::string_view> keys,
                     Diagnostics& diagnostics) {
    for (const std::string_view key : keys) {
        const auto value = object.value().find(key);
        if (!value) continue;
        diagnostics.error(value->whereKey(),
                          fmt::format("{} describes an image, but this port is a buffer", inQuotes(key)));
    }
}

InputPort readInput(const std::string& name, const json::Value& value, Diagnostics& diagnostics) {
    InputPort port;
    port.name = name;
    port.where = value.whereKey();
    json::ObjectReader object(value, "an input", keys::input(), diagnostics);
    readDoc(object, port.doc);
    readNeutral(object, port.neutral);
    if (const auto optional = object.optional("optional")) {
        port.optional = optional->boolean(diagnostics, "true or false").value_or(false);
    }
    if (const auto neededWhen = object.optional("neededWhen"))
        port.neededWhen = readExpression(*neededWhen, diagnostics);
    if (const auto format = object.optional("format")) port.format = readFormat(*format, diagnostics);
    port.bufferElement = readBufferElement(object);
    static constexpr std::array<std::string_view, 1> imageKeys{"format"};
    if (!port.bufferElement.empty()) refuseImageKeys(object, imageKeys, diagnostics);
    object.finish();
    return port;
}

void readImage(json::ObjectReader& object, OutputPort& port) {
    Diagnostics& diagnostics = object.diagnostics();
    if (const auto format = object.optional("format"))
        port.format = readFormat(*format, diagnostics).value_or(port.format);
    if (const auto size = object.optional("size")) port.size = readSize(*size, diagnostics);
    if (const auto value = object.optional("mips")) {
        if (auto mips = readCount(*value, "the number of mips", 0, mostMips, diagnostics))
            port.mips = std::move(*mips);
    }
    if (const auto value = object.optional("layers")) {
        auto layers = readCount(*value, "the number of layers", 1, mostLayers, diagnostics);
        if (layers) port.layers = std::move(*layers);
    }
}

void readBufferCount(json::ObjectReader& object, OutputPort& port) {
    Diagnostics& diagnostics = object.diagnostics();
    const auto value = object.optional("count");
    const bool isBuffer = object.value().find("buffer").has_value();
    if (isBuffer && !value && port.modifies.empty())
        diagnostics.error(port.where, fmt::format("the buffer {} needs \"count\"", inQuotes(port.name)));
    if (!value) return;
    if (!isBuffer) {
        diagnostics.error(value->whereKey(), "\"count\" describes a buffer, but this port is an image");
        return;
    }
    auto count = readCount(*value, "the number of elements", 0, mostElements, diagnostics);
    if (count) port.bufferCount = std::move(*count);
}

/// What is modified keeps its size.
void readModifies(json::ObjectReader& object, OutputPort& port) {
    Diagnostics& diagnostics = object.diagnostics();
    const auto value = object.optional("modifies");
    if (!value) return;
    port.modifies = value->string(diagnostics, "an input's name").value_or("");
    port.whereModifies = value->where();
    if (value->isString() && port.modifies.empty())
        diagnostics.error(value->where(), "expected an input's name, found \"\"");
    for (const std::string_view key : {"size", "mips", "layers", "count"}) {
        const auto other = object.value().find(key);
        if (!other) continue;
        diagnostics.error(other->whereKey(),
                          fmt::format("an output that modifies an input has that input's {}", key));
    }
}

OutputPort readOutput(const std::string& name, const json::Value& value, Diagnostics& diagnostics) {
    OutputPort port;
    port.name = name;
    port.where = value.whereKey();
    json::ObjectReader object(value, "an output", keys::output(), diagnostics);
    readDoc(object, port.doc);
    readNeutral(object, port.neutral);
    readModifies(object, port);
    readImage(object, port);
    port.bufferElement = readBufferElement(object);
    readBufferCount(object, port);
    static constexpr std::array<std::string_view, 4> imageKeys{"format", "size", "mips", "layers"};
    if (!port.bufferElement.empty()) refuseImageKeys(object, imageKeys, diagnostics);
    object.finish();
    return port;
}

template<class Port>
std::vector<Port> readPorts(const json::Value& value, std::string_view what, Diagnostics& diagnostics,
                            Port (*readOne)(const std::string&, const json::Value&, Diagnostics&)) {
    std::vector<Port> ports;
    if (!value.isObject()) {
        diagnostics.error(value.where(),
                          fmt::format("expected an object of {}s by name, found {}", what, value.describe()));
    }
    for (const auto& [name, member] : value.members()) {
        checkGlslName(name, member.whereKey(), fmt::format("an {}", what), diagnostics);
        ports.push_back(readOne(name, member, diagnostics));
    }
    return ports;
}

}  // namespace

std::vector<InputPort> readInputs(const json::Value& value, Diagnostics& diagnostics) {
    return readPorts<InputPort>(value, "input", diagnostics, readInput);
}

std::vector<OutputPort> readOutputs(const json::Value& value, Diagnostics& diagnostics) {
    return readPorts<OutputPort>(value, "output", diagnostics, readOutput);
}

}  // namespace nephrite::graph
