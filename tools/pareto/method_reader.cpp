// A graph with its settings, or a sum of references; and what either is held against.
#include "pareto/method_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "pareto/suite_values.h"

namespace nephrite::pareto {
namespace {

using json::ObjectReader;
using json::Value;

/// Parameter values of one method, multiplied out.
constexpr std::size_t mostPoints = 256;

std::optional<truth::Mode> readMode(const Value& value, Diagnostics& diagnostics) {
    const auto name = value.string(diagnostics, "the name of a reference");
    return name ? modeCalled(*name, value.where(), diagnostics) : std::nullopt;
}

Setting settingOf(const std::string& parameter, const SourceLocation& where, const Value& value) {
    return {parameter, std::string(value.sourceText()), where, value.where()};
}

std::vector<Variation> readVariations(const Value& vary, Diagnostics& diagnostics) {
    std::vector<Variation> variations;
    std::size_t points = 1;
    for (const auto& [name, value] : membersOf(vary, "parameters", diagnostics)) {
        Variation& variation = variations.emplace_back();
        for (const Value& element : elementsOf(value, "values", diagnostics))
            variation.push_back(settingOf(name, value.whereKey(), element));
        points = std::min(points * variation.size(), mostPoints + 1);
    }
    if (points > mostPoints)
        diagnostics.error(vary.where(), fmt::format("these make more than {} combinations", mostPoints));
    return variations;
}

void readGraphSettings(ObjectReader& object, Method& method) {
    Diagnostics& diagnostics = object.diagnostics();
    if (const auto skip = object.optional("skip"))
        method.skip = skip->boolean(diagnostics, "true or false").value_or(true);
    if (const auto set = object.optional("set"))
        for (const auto& [name, value] : membersOf(*set, "parameters", diagnostics))
            method.settings.push_back(settingOf(name, value.whereKey(), value));
    if (const auto vary = object.optional("vary")) method.variations = readVariations(*vary, diagnostics);
}

void readComparisons(ObjectReader& object, Method& method) {
    Diagnostics& diagnostics = object.diagnostics();
    const auto against = object.optional("against");
    if (!against) {
        method.against = {{truth::Mode::Volume, "color", method.where}};
        return;
    }
    for (const auto& [name, value] : membersOf(*against, "ports by reference", diagnostics)) {
        const auto mode = modeCalled(name, value.whereKey(), diagnostics);
        const auto port = value.string(diagnostics, "\"color\" or a \"node.port\"");
        if (!mode || !port) continue;
        if (!method.references.empty() && *port != "color")
            diagnostics.error(value.where(), fmt::format("references have nothing but \"color\", found {}",
                                                         value.describe()));
        method.against.push_back({*mode, *port, value.where()});
    }
}

}  // namespace

Method readMethod(const std::string& name, const Value& value, const std::filesystem::path& folder,
                  Diagnostics& diagnostics) {
    Method method;
    method.name = name;
    method.where = value.whereKey();
    ObjectReader object(value, "a method", diagnostics);
    const auto graph = object.optional("graph");
    const auto references = object.optional("references");
    if (value.isObject() && graph.has_value() == references.has_value())
        diagnostics.error(value.where(), fmt::format("a method needs either \"graph\" or \"references\"{}",
                                                     graph ? ", found both" : ""));
    if (graph) {
        method.graph = readPath(*graph, "a graph file's name", folder, diagnostics);
        method.whereGraph = graph->where();
        readGraphSettings(object, method);
    }
    if (references)
        for (const Value& element : elementsOf(*references, "references", diagnostics))
            if (const auto mode = readMode(element, diagnostics)) method.references.push_back(*mode);
    readComparisons(object, method);
    object.finish();
    return method;
}

}  // namespace nephrite::pareto
