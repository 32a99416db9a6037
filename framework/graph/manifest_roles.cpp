// See manifest_roles.h.
#include "graph/manifest_roles.h"

#include <fmt/format.h>

#include <unordered_map>

#include "graph/value_readers.h"

namespace nephrite::graph {
namespace {

/// The key of an output in the manifest's text, if it is there.
std::optional<json::Value> keyOf(const json::Value& manifest, const OutputPort& output,
                                 std::string_view key) {
    const auto outputs = manifest.find("outputs");
    const auto port = outputs ? outputs->find(output.name) : std::nullopt;
    return port ? port->find(key) : std::nullopt;
}

std::string sortOf(const std::string& element, bool isInteger) {
    if (!element.empty()) return fmt::format("a buffer of {}", element);
    return isInteger ? "an image of unsigned integers (r32u)" : "an image of floats";
}

/// What the output leaves unsaid is as the input's; what it says must agree.
void matchSorts(OutputPort& output, const InputPort& input, const json::Value& manifest,
                Diagnostics& diagnostics) {
    const auto format = keyOf(manifest, output, "format");
    if (!keyOf(manifest, output, "buffer")) output.bufferElement = input.bufferElement;
    if (!input.bufferElement.empty() && format && output.bufferElement == input.bufferElement) {
        diagnostics.error(format->whereKey(), "\"format\" describes an image, but this port is a buffer");
        return;
    }
    if (!format && input.format) output.format = *input.format;
    const bool expectsInteger = input.format && info(*input.format).isUnsignedInteger;
    const std::string expected = sortOf(input.bufferElement, expectsInteger);
    const std::string found = sortOf(output.bufferElement, info(output.format).isUnsignedInteger);
    if (expected == found) return;
    diagnostics.error(output.whereModifies,
                      fmt::format("{} is {}, but {}, which it modifies, is {}", inQuotes(output.name), found,
                                  inQuotes(input.name), expected));
}

}  // namespace

void resolveModifies(PassType& type, const json::Value& manifest, Diagnostics& diagnostics) {
    std::unordered_map<std::string_view, std::string_view> modifiers;  // output by the input it modifies
    for (OutputPort& output : type.outputs) {
        if (output.modifies.empty()) continue;
        const InputPort* input = findNamed(type.inputs, output.modifies);
        const auto refuse = [&](std::string message) {
            diagnostics.error(output.whereModifies, std::move(message));
        };
        if (input == nullptr) {
            refuse(fmt::format("unknown input {}{}", inQuotes(output.modifies),
                               suggestionAmong(output.modifies, type.inputs)));
            continue;
        }
        const auto [other, isNew] = modifiers.emplace(input->name, output.name);
        if (!isNew) {
            refuse(fmt::format("{} modifies {} already", inQuotes(other->second), inQuotes(input->name)));
        } else if (input->optional) {
            refuse(fmt::format("{} is optional: an input that is modified must be connected",
                               inQuotes(input->name)));
        } else if (!type.domain.empty()) {
            refuse(
                "a pass with a domain leaves its outputs neutral outside it, so they cannot modify inputs");
        }
        output.modifiedInput = static_cast<Index>(input - type.inputs.data());
        matchSorts(output, *input, manifest, diagnostics);
    }
}

void resolveDomain(PassType& type, const json::Value& value, Diagnostics& diagnostics) {
    const InputPort* input = findNamed(type.inputs, type.domain);
    const auto refuse = [&](std::string message) { diagnostics.error(value.where(), std::move(message)); };
    if (type.kind != PassKind::Pixel) {
        refuse(fmt::format("only a pixel pass has a domain, this one is {}", name(type.kind)));
    } else if (type.forEach == ForEach::Mips) {
        refuse("a pass that runs for each of its mips has no domain");
    } else if (input == nullptr) {
        refuse(fmt::format("unknown input {}{}", inQuotes(type.domain),
                           suggestionAmong(type.domain, type.inputs)));
    } else if (!input->bufferElement.empty()) {
        refuse(fmt::format("{} is a buffer, a domain is an image of floats", inQuotes(type.domain)));
    } else if (input->format && info(*input->format).isUnsignedInteger) {
        refuse(
            fmt::format("{} holds unsigned integers, a domain is an image of floats", inQuotes(type.domain)));
    } else {
        type.domainInput = static_cast<Index>(input - type.inputs.data());
    }
}

void refuseUndrawnParts(const PassType& type, const json::Value& manifest, Diagnostics& diagnostics) {
    if (type.kind != PassKind::Raster) return;
    for (const OutputPort& output : type.outputs) {
        if (!output.modifies.empty() || !output.bufferElement.empty()) continue;
        const auto refuse = [&](std::string_view key, const Expression& count, std::string_view parts) {
            const auto value = keyOf(manifest, output, key);
            if (value && count.literal() != 1.0)
                diagnostics.error(value->whereKey(),
                                  fmt::format("a raster pass draws to one of its {}", parts));
        };
        refuse("mips", output.mips, "mips");
        refuse("layers", output.layers, "layers");
    }
}

std::optional<MipsFault> whyNotForEachMip(const PassType& type) {
    if (type.kind == PassKind::Raster) {
        return MipsFault{type.where, "a raster pass draws to one level and cannot run for each of its mips"};
    }
    if (type.outputs.empty())
        return MipsFault{type.where, "a pass that runs for each of its mips needs an image as an output"};
    for (const OutputPort& output : type.outputs) {
        if (!output.bufferElement.empty()) {
            return MipsFault{
                output.where,
                fmt::format("{} is a buffer, but the pass runs for each of its mips", inQuotes(output.name))};
        }
        if (output.modifies.empty() && output.mips.literal() == 1.0) {
            return MipsFault{output.where, fmt::format("{} has 1 mip, but the pass runs for each of its mips",
                                                       inQuotes(output.name))};
        }
    }
    return std::nullopt;
}

}  // namespace nephrite::graph
