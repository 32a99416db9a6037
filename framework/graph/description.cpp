// A graph file read: every node, parameter and output in its own words.
#include "graph/description.h"

#include <fmt/format.h>

#include "graph/graph_parameter.h"
#include "graph/keys.h"
#include "graph/value_readers.h"

namespace nephrite::graph {
namespace {

void checkName(const json::Value& member, const std::string& name, std::string_view what, bool dashes,
               Diagnostics& diagnostics) {
    if (isIdentifier(name, dashes)) return;
    diagnostics.error(member.whereKey(),
                      fmt::format("{} cannot be called {}: expected letters, digits{} and _, no digit first",
                                  what, inQuotes(name), dashes ? ", -" : ""));
}

/// The members of `value`, or a fault if it is no object.
std::vector<std::pair<std::string, json::Value>> membersOf(const json::Value& value, std::string_view what,
                                                           Diagnostics& diagnostics) {
    if (!value.isObject()) {
        diagnostics.error(value.where(),
                          fmt::format("expected an object of {}, found {}", what, value.describe()));
    }
    return value.members();
}

std::vector<std::pair<std::string, PortReference>> readConnections(const json::Value& value,
                                                                   std::string_view what,
                                                                   Diagnostics& diagnostics) {
    std::vector<std::pair<std::string, PortReference>> connections;
    for (const auto& [name, member] : membersOf(value, what, diagnostics)) {
        const auto text = member.string(diagnostics, "a \"node.port\"");
        if (!text) continue;
        auto reference = readPortReference(*text, member.where(), diagnostics);
        if (!reference) continue;
        reference->whereKey = member.whereKey();
        connections.emplace_back(name, std::move(*reference));
    }
    return connections;
}

/// The NAME of a string "$NAME", or nothing.
std::optional<std::string> graphParameterName(const json::Value& value) {
    if (!value.isString()) return std::nullopt;
    const std::string text = value.raw().asString();
    if (text.empty() || text[0] != '$') return std::nullopt;
    return text.substr(1);
}

class NodeReader {
  public:
    NodeReader(const std::string& name, const json::Value& value, Diagnostics& diagnostics)
        : object_(value, "a node", keys::node(), diagnostics), diagnostics_(diagnostics) {
        node_.name = name;
        node_.where = value.whereKey();
        node_.wherePass = value.where();
    }

    NodeDescription read() {
        if (const auto value = object_.optional("pass")) {
            node_.passType = value->string(diagnostics_, "the name of a pass type").value_or("");
            node_.wherePass = value->where();
        }
        readIteration();
        if (const auto value = object_.optional("in"))
            node_.inputs = readConnections(*value, "inputs", diagnostics_);
        if (const auto value = object_.optional("set")) readSettings(*value);
        if (const auto value = object_.optional("format")) readFormats(*value);
        if (const auto value = object_.optional("when")) node_.when = readExpression(*value, diagnostics_);
        if (const auto value = object_.optional("doc")) value->string(diagnostics_, "a string");
        readNodeSize();
        object_.finish();
        return std::move(node_);
    }

  private:
    void readIteration() {
        static constexpr std::array<std::string_view, 2> views{"camera", "light"};
        if (const auto value = object_.optional("forEach")) {
            node_.forEach = readForEach(*value, diagnostics_);
            node_.whereForEach = value->where();
        }
        if (const auto value = object_.optional("view")) {
            node_.view = static_cast<ViewKind>(readChoice(*value, views, diagnostics_).value_or(0));
            node_.whereView = value->where();
        }
    }

    void readSettings(const json::Value& value) {
        for (const auto& [name, member] : membersOf(value, "parameters", diagnostics_)) {
            if (auto graphName = graphParameterName(member)) {
                node_.settings.push_back({name, std::move(*graphName), member.where()});
            } else {
                node_.settings.push_back({name, member, member.where()});
            }
        }
    }

    void readFormats(const json::Value& value) {
        for (const auto& [name, member] : membersOf(value, "pixel formats by output", diagnostics_)) {
            const auto format = readFormat(member, diagnostics_);
            if (format) node_.formats.push_back({name, *format, member.whereKey()});
        }
    }

    void readNodeSize() {
        const auto value = object_.optional("size");
        if (!value) return;
        node_.size = readSize(*value, diagnostics_);
        if (!node_.size || node_.size->kind != SizeRule::Kind::Like) return;
        const auto reference = readPortReference(node_.size->like, node_.size->where, diagnostics_);
        if (!reference || (reference->framesBack == 0 && !reference->mip && !reference->layer)) return;
        diagnostics_.error(node_.size->where,
                           fmt::format("a size is like that of a whole port of this frame, found {}",
                                       inQuotes(node_.size->like)));
    }

    json::ObjectReader object_;
    Diagnostics& diagnostics_;
    NodeDescription node_;
};

GraphImport readImport(const std::string& name, const json::Value& value, Diagnostics& diagnostics) {
    GraphImport result;
    result.name = name;
    result.where = value.whereKey();
    json::ObjectReader object(value, "an import", keys::graphImport(), diagnostics);
    if (const auto image = object.optional("image")) {
        const auto file = image->string(diagnostics, "an image's file name");
        if (file && file->empty())
            diagnostics.error(image->where(), "expected an image's file name, found \"\"");
        if (file) result.image = std::filesystem::path(result.where.file).parent_path() / *file;
    }
    if (const auto format = object.optional("format")) {
        result.format = readFormat(*format, diagnostics).value_or(result.format);
        if (info(result.format).isDepth)
            diagnostics.error(format->where(), "an import cannot be d32f, which raster passes alone write");
    }
    if (const auto doc = object.optional("doc"))
        result.doc = doc->string(diagnostics, "a string").value_or("");
    object.finish();
    return result;
}

void readNodes(const json::Value& value, GraphDescription& graph, Diagnostics& diagnostics) {
    const auto members = membersOf(value, "nodes", diagnostics);
    if (value.isObject() && members.empty() && graph.imports.empty())
        diagnostics.error(value.where(), "a graph needs at least one node");
    graph.nodes.reserve(members.size());
    for (const auto& [name, member] : members) {
        checkName(member, name, "a node", true, diagnostics);
        graph.nodes.push_back(NodeReader(name, member, diagnostics).read());
    }
}

void readOutputs(const json::Value& value, GraphDescription& graph, Diagnostics& diagnostics) {
    if (value.isObject() && value.size() == 0) {
        diagnostics.error(value.where(),
                          "a graph without outputs computes nothing, expected at least one "
                          "\"name\": \"node.port\"");
    }
    graph.outputs = readConnections(value, "outputs", diagnostics);
}

}  // namespace

GraphDescription readGraph(const json::Value& value) {
    Diagnostics diagnostics;
    GraphDescription graph;
    graph.file = value.where().file;
    graph.name = std::filesystem::path(graph.file).stem().string();
    json::ObjectReader object(value, "a graph", keys::graph(), diagnostics);
    if (const auto name = object.optional("name"))
        graph.name = name->string(diagnostics, "a string").value_or("");
    if (const auto doc = object.optional("doc")) doc->string(diagnostics, "a string");
    if (const auto parameters = object.optional("parameters")) {
        for (const auto& [name, member] : membersOf(*parameters, "parameters", diagnostics)) {
            checkName(member, name, "a graph parameter", false, diagnostics);
            if (auto parameter = readGraphParameter(name, member, diagnostics)) {
                graph.parameters.push_back(std::move(*parameter));
            }
        }
    }
    if (const auto imports = object.optional("imports")) {
        for (const auto& [name, member] : membersOf(*imports, "imports", diagnostics)) {
            checkName(member, name, "an import", true, diagnostics);
            graph.imports.push_back(readImport(name, member, diagnostics));
        }
    }
    if (const auto nodes = object.optional("nodes")) readNodes(*nodes, graph, diagnostics);
    if (const auto outputs = object.optional("outputs")) readOutputs(*outputs, graph, diagnostics);
    object.finish();
    diagnostics.throwIfErrors();
    return graph;
}

GraphDescription readGraph(const std::filesystem::path& file) {
    return readGraph(json::parseFile(file));
}

}  // namespace nephrite::graph
