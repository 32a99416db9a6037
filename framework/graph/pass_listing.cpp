// See pass_listing.h.
#include "graph/pass_listing.h"

#include <fmt/format.h>
#include <json/writer.h>

#include "graph/parameter_checks.h"

namespace nephrite::graph {
namespace {

std::string joined(std::span<const double> numbers) {
    return numbers.size() == 1 ? fmt::format("{}", numbers[0])
                               : fmt::format("[{}]", fmt::join(numbers, ", "));
}

/// "true", "12", "[0.3, 0.3]".
std::string valueText(const ParameterDeclaration& parameter) {
    if (parameter.type == ParameterType::Bool)
        return parameter.defaultValue.components[0] != 0 ? "true" : "false";
    const std::string text = joined(parameter.defaultValue.components);
    return parameter.type == ParameterType::FloatArray && parameter.count == 1 ? "[" + text + "]" : text;
}

std::string sizeText(const SizeRule& size) {
    switch (size.kind) {
        case SizeRule::Kind::Absolute:
            return fmt::format("[{}, {}]", size.width.text(), size.height.text());
        case SizeRule::Kind::ScaleOfView:
            return fmt::format("{} of the view", size.width.text());
        case SizeRule::Kind::Like:
            return fmt::format("like {}", size.like);
    }
    return {};
}

std::string inputText(const InputPort& port) {
    std::string text = port.bufferElement.empty() ? "" : fmt::format(", buffer of {}", port.bufferElement);
    if (port.format) text += fmt::format(", {}", info(*port.format).name);
    if (port.optional) text += fmt::format(", optional (neutral {})", joined(port.neutral));
    if (port.neededWhen) text += fmt::format(", needed when {}", port.neededWhen->text());
    return text;
}

std::string outputText(const OutputPort& port) {
    if (!port.modifies.empty()) return fmt::format(", modifies {}", port.modifies);
    if (!port.bufferElement.empty()) {
        return fmt::format(", buffer of {} {}", port.bufferCount.text(), port.bufferElement);
    }
    std::string text = fmt::format(", {}", info(port.format).name);
    if (port.size) text += fmt::format(", size {}", sizeText(*port.size));
    if (port.mips.literal() != 1.0) text += fmt::format(", mips {}", port.mips.text());
    if (port.layers.literal() != 1.0) text += fmt::format(", layers {}", port.layers.text());
    return text;
}

std::string parameterText(const ParameterDeclaration& parameter) {
    std::string text = fmt::format(", {}, default {}", typeName(parameter), valueText(parameter));
    if (parameter.range) text += fmt::format(", {} to {}", (*parameter.range)[0], (*parameter.range)[1]);
    if (parameter.specialize) text += ", specialized";
    return text;
}

template<class Items, class Describe>
std::string section(std::string_view title, const Items& items, Describe describe) {
    if (items.empty()) return {};
    std::string text = fmt::format("  {}\n", title);
    for (const auto& item : items) {
        text +=
            fmt::format("    {}{}{}{}\n", item.name, describe(item), item.doc.empty() ? "" : ": ", item.doc);
    }
    return text;
}

Json::Value numbersAsJson(std::span<const double> numbers) {
    Json::Value array(Json::arrayValue);
    for (const double number : numbers) array.append(number);
    return array;
}

Json::Value expressionAsJson(const Expression& expression) {
    const std::optional<double> literal = expression.literal();
    return literal ? Json::Value(*literal) : Json::Value(expression.text());
}

Json::Value sizeAsJson(const SizeRule& size) {
    Json::Value json;
    if (size.kind == SizeRule::Kind::Absolute) {
        json.append(expressionAsJson(size.width));
        json.append(expressionAsJson(size.height));
    } else if (size.kind == SizeRule::Kind::ScaleOfView) {
        json["scale"] = expressionAsJson(size.width);
    } else {
        json["like"] = size.like;
    }
    return json;
}

Json::Value inputAsJson(const InputPort& port) {
    Json::Value json;
    json["name"] = port.name;
    json["doc"] = port.doc;
    json["optional"] = port.optional;
    json["neutral"] = numbersAsJson(port.neutral);
    if (port.neededWhen) json["neededWhen"] = expressionAsJson(*port.neededWhen);
    if (port.format) json["format"] = std::string(info(*port.format).name);
    if (!port.bufferElement.empty()) json["buffer"] = port.bufferElement;
    return json;
}

Json::Value outputAsJson(const OutputPort& port) {
    Json::Value json;
    json["name"] = port.name;
    json["doc"] = port.doc;
    json["neutral"] = numbersAsJson(port.neutral);
    if (!port.modifies.empty()) {
        json["modifies"] = port.modifies;
        return json;
    }
    if (!port.bufferElement.empty()) {
        json["buffer"] = port.bufferElement;
        json["count"] = expressionAsJson(port.bufferCount);
        return json;
    }
    json["format"] = std::string(info(port.format).name);
    json["mips"] = expressionAsJson(port.mips);
    json["layers"] = expressionAsJson(port.layers);
    if (port.size) json["size"] = sizeAsJson(*port.size);
    return json;
}

Json::Value parameterAsJson(const ParameterDeclaration& parameter) {
    Json::Value json;
    json["name"] = parameter.name;
    json["type"] = typeName(parameter);
    json["doc"] = parameter.doc;
    json["specialize"] = parameter.specialize;
    const bool isArray = parameter.count > 1 || parameter.type == ParameterType::FloatArray;
    const auto& components = parameter.defaultValue.components;
    if (parameter.type == ParameterType::Bool) {
        json["default"] = components[0] != 0;
    } else {
        json["default"] = isArray ? numbersAsJson(components) : Json::Value(components[0]);
    }
    if (parameter.range) json["range"] = numbersAsJson(*parameter.range);
    return json;
}

template<class Items>
Json::Value arrayAsJson(const Items& items, Json::Value (*one)(const typename Items::value_type&)) {
    Json::Value array(Json::arrayValue);
    for (const auto& item : items) array.append(one(item));
    return array;
}

Json::Value passAsJson(const PassType& type) {
    Json::Value json;
    json["name"] = type.name;
    json["kind"] = std::string(name(type.kind));
    json["doc"] = type.doc;
    json["shader"] = type.shader.empty() ? Json::Value() : Json::Value(type.shader.string());
    json["inputs"] = arrayAsJson(type.inputs, inputAsJson);
    json["outputs"] = arrayAsJson(type.outputs, outputAsJson);
    json["parameters"] = arrayAsJson(type.parameters, parameterAsJson);
    json["skipWhen"] = type.skipWhen ? expressionAsJson(*type.skipWhen) : Json::Value();
    json["forEach"] =
        type.forEach == ForEach::Nothing ? Json::Value() : Json::Value(std::string(name(type.forEach)));
    json["domain"] = type.domain.empty() ? Json::Value() : Json::Value(type.domain);
    json["sideEffect"] = type.sideEffect;
    return json;
}

std::string jsonText(const Json::Value& json) {
    Json::StreamWriterBuilder builder;
    builder["indentation"] = "  ";
    builder["precision"] = 17;
    return Json::writeString(builder, json) + "\n";
}

/// Up to a full stop before a capital letter, so that "Eq. 13" does not end a sentence.
std::string_view firstSentence(std::string_view text) {
    for (std::size_t i = 0; i + 2 < text.size(); ++i) {
        if (text[i] == '.' && text[i + 1] == ' ' && text[i + 2] >= 'A' && text[i + 2] <= 'Z')
            return text.substr(0, i + 1);
    }
    return text;
}

/// Every pass type that can be read; the faults of the others go to `diagnostics`.
std::vector<const PassType*> readable(const PassLibrary& library, Diagnostics& diagnostics) {
    std::vector<const PassType*> types;
    for (const std::string& name : library.names()) {
        try {
            types.push_back(library.find(name));
        } catch (const InputError& error) {
            for (const Diagnostic& fault : error.faults()) diagnostics.error(fault.where, fault.message);
        }
    }
    return types;
}

}  // namespace

std::string describePass(const PassType& type) {
    std::string text = fmt::format("{} ({})\n", type.name, name(type.kind));
    if (!type.doc.empty()) text += fmt::format("  {}\n", type.doc);
    if (!type.shader.empty()) text += fmt::format("  shader {}\n", type.shader.string());
    if (type.forEach == ForEach::Lights) text += "  runs for each light's views\n";
    if (type.forEach == ForEach::Mips) text += "  runs for each of its outputs' mips\n";
    if (!type.domain.empty())
        text += fmt::format("  neutral where the last channel of {} is 0\n", type.domain);
    if (type.skipWhen) text += fmt::format("  skipped when {}\n", type.skipWhen->text());
    text += section("inputs", type.inputs, inputText);
    text += section("outputs", type.outputs, outputText);
    text += section("parameters", type.parameters, parameterText);
    return text;
}

std::string describePassAsJson(const PassType& type) {
    return jsonText(passAsJson(type));
}

std::string listPasses(const PassLibrary& library, Diagnostics& diagnostics) {
    std::string text;
    for (const PassType* type : readable(library, diagnostics)) {
        text += fmt::format("{:<24} {:<8} {}", type->name, name(type->kind), firstSentence(type->doc));
        text.erase(text.find_last_not_of(' ') + 1);
        text += '\n';
    }
    return text;
}

std::string listPassesAsJson(const PassLibrary& library, Diagnostics& diagnostics) {
    Json::Value array(Json::arrayValue);
    for (const PassType* type : readable(library, diagnostics)) array.append(passAsJson(*type));
    return jsonText(array);
}

}  // namespace nephrite::graph
