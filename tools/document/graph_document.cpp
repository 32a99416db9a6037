// See graph_document.h: what edits there are, and how each becomes a change of the text.
#include "document/graph_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "graph/compatible_types.h"
#include "graph/value_readers.h"
#include "text/json_edit.h"

namespace nephrite::document {
namespace {

/// A pass library and a graph that points into it, with one life.
struct Linked {
    std::shared_ptr<const graph::PassLibrary> passTypes;
    std::shared_ptr<const graph::LinkedGraph> graph;
};

bool isSwitchedOff(const graph::NodeDescription& node) {
    return node.when && node.when->literal() == 0.0;
}

/// Removes a member, and the object it was in if nothing is left there.
json::Value without(const json::Value& root, const json::Path& path) {
    if (!json::findAt(root, path)) return root;
    json::Value result = json::removeAt(root, path);
    const json::Path object(path.begin(), path.end() - 1);
    const auto left = json::findAt(result, object);
    const bool isEmpty = left && left->isObject() &&
                         left->sourceText().find_first_not_of("{} \t\r\n") == std::string_view::npos;
    return isEmpty ? json::removeAt(result, object) : result;
}

/// Faults of a value that was to be set stand at the setting: the text that would hold it was never saved.
/// What is wrong elsewhere in the file for its sake stays there.
std::vector<Diagnostic> asFaultsOfSetting(std::vector<Diagnostic> faults, const std::string& file,
                                          const std::optional<json::Value>& value,
                                          const std::string& setting) {
    for (Diagnostic& fault : faults) {
        const bool isElsewhere = fault.where.file == file && !(value && fault.where == value->where());
        if (!isElsewhere) fault.where = {setting};
    }
    return faults;
}

/// `path` as `source` has it.
json::Value restored(const json::Value& root, const json::Path& path, const json::Value& source) {
    const auto value = json::findAt(source, path);
    return value ? json::setAt(root, path, value->sourceText()) : without(root, path);
}

/// The names in `before` that `after` does not have, as `set.taps`.
template<class List, class Name>
std::vector<std::string> namesLost(std::string_view key, const List& before, const List& after, Name name) {
    std::vector<std::string> lost;
    for (const auto& one : before) {
        const bool isKept = std::any_of(after.begin(), after.end(),
                                        [&](const auto& other) { return other.*name == one.*name; });
        if (!isKept) lost.push_back(fmt::format("{}.{}", key, one.*name));
    }
    return lost;
}

}  // namespace

GraphDocument::GraphDocument(std::filesystem::path file, std::shared_ptr<const graph::PassLibrary> passTypes)
    : file_(std::move(file)),
      passTypes_(std::move(passTypes)),
      saved_(json::parseFile(file_)),
      savedParameters_(graph::readGraph(saved_).parameters),
      root_(saved_),
      graph_(link(root_)),
      versions_{{text(), {}, {}}} {}

std::shared_ptr<const graph::LinkedGraph> GraphDocument::link(const json::Value& root) const {
    auto linked = std::make_shared<Linked>();
    linked->passTypes = passTypes_;
    linked->graph = graph::link(graph::readGraph(root), *passTypes_);
    const graph::LinkedGraph* graph = linked->graph.get();
    return {std::move(linked), graph};
}

void GraphDocument::setPassTypes(std::shared_ptr<const graph::PassLibrary> passTypes) {
    std::swap(passTypes_, passTypes);
    try {
        graph_ = link(root_);
    } catch (...) {
        std::swap(passTypes_, passTypes);
        throw;
    }
}

graph::Index GraphDocument::indexOf(const std::string& node) const {
    const auto& nodes = graph_->description.nodes;
    for (graph::Index i = 0; i < nodes.size(); ++i) {
        if (nodes[i].name == node && graph_->nodes[i].role == graph::NodeRole::Pass) return i;
    }
    throw InputError({file_.string()}, fmt::format("the graph has no node {}{}", inQuotes(node),
                                                   graph::suggestionAmong(node, nodes)));
}

json::Path GraphDocument::pathOf(const std::string& target) const {
    const std::size_t dot = target.find('.');
    if (dot != std::string::npos) {
        const std::string node = target.substr(0, dot);
        const graph::PassType& type = *graph_->nodes[indexOf(node)].type;
        const std::string parameter = target.substr(dot + 1);
        if (graph::findNamed(type.parameters, parameter) == nullptr) {
            throw InputError(
                {file_.string()},
                fmt::format("node {} (pass {}) has no parameter {}{}", inQuotes(node), inQuotes(type.name),
                            inQuotes(parameter), graph::suggestionAmong(parameter, type.parameters)));
        }
        return {"nodes", node, "set", parameter};
    }
    const auto& parameters = graph_->description.parameters;
    if (graph::findNamed(parameters, target) == nullptr) {
        throw InputError({file_.string()}, fmt::format("the graph has no parameter {}{}", inQuotes(target),
                                                       graph::suggestionAmong(target, parameters)));
    }
    return {"parameters", target, "value"};
}

void GraphDocument::set(const std::string& target, std::string_view json, Gesture gesture) {
    const json::Path path = pathOf(target);
    std::optional<json::Value> next;
    try {
        // A graph parameter keeps its shape, which the file itself does not demand.
        if (target.find('.') == std::string::npos)
            graph::applySetting(*graph_, graph_->values, fmt::format("{}={}", target, json));
        next = json::setAt(root_, path, json);
        if (gesture == Gesture::Starts) versions_[current_].gesture.clear();
        edit(*next, "set " + target, target);
    } catch (const InputError& error) {
        const auto value = next ? json::findAt(*next, path) : std::nullopt;
        throw InputError(
            asFaultsOfSetting(error.faults(), file_.string(), value, fmt::format("set {}={}", target, json)));
    }
}

void GraphDocument::reset(const std::string& target) {
    const json::Path path = pathOf(target);
    const bool isNodes = target.find('.') != std::string::npos;
    edit(isNodes ? without(root_, path) : restored(root_, path, saved_), "reset " + target);
}

void GraphDocument::revert(const std::string& target) {
    edit(restored(root_, pathOf(target), saved_), "revert " + target);
}

bool GraphDocument::differsFromFile(const std::string& target) const {
    const json::Path path = pathOf(target);
    const auto now = json::findAt(root_, path);
    const auto then = json::findAt(saved_, path);
    return now.has_value() != then.has_value() || (now && now->raw() != then->raw());
}

bool GraphDocument::isOn(const std::string& node) const {
    return !isSwitchedOff(graph_->description.nodes[indexOf(node)]);
}

void GraphDocument::switchNode(const std::string& node, bool on) {
    if (isOn(node) == on) return;
    const json::Path path{"nodes", node, "when"};
    if (!on) return edit(json::setAt(root_, path, "false"), "switch off " + node);
    edit(restored(root_, path, lastWithNodeOn(node)), "switch on " + node);
}

json::Value GraphDocument::lastWithNodeOn(const std::string& node) const {
    for (std::size_t i = current_ + 1; i > 0; --i) {
        json::Value root = json::parse(versions_[i - 1].text, file_.string());
        const graph::GraphDescription graph = graph::readGraph(root);
        const graph::NodeDescription* found = graph::findNamed(graph.nodes, node);
        if (found != nullptr && !isSwitchedOff(*found)) return root;
    }
    const json::Path path{"nodes", node, "when"};
    const auto inFile = graph::readGraph(saved_);
    const graph::NodeDescription* found = graph::findNamed(inFile.nodes, node);
    return found != nullptr && !isSwitchedOff(*found) ? saved_ : json::removeAt(root_, path);
}

std::vector<std::string> GraphDocument::swapPass(const std::string& node, const std::string& passType) {
    const graph::NodeDescription& before = graph_->description.nodes[indexOf(node)];
    json::Value next = json::setAt(root_, {"nodes", node, "pass"}, json::jsonString(passType));
    std::vector<std::string> lost;
    if (const graph::PassType* type = passTypes_->find(passType)) {
        const graph::NodeDescription after = graph::withPassType(graph_->description, before, *type);
        lost = namesLost("set", before.settings, after.settings, &graph::ParameterSetting::parameter);
        const auto formats = namesLost("format", before.formats, after.formats, &graph::FormatOverride::port);
        lost.insert(lost.end(), formats.begin(), formats.end());
    }
    for (const std::string& name : lost) {
        const std::size_t dot = name.find('.');
        next = without(next, {"nodes", node, name.substr(0, dot), name.substr(dot + 1)});
    }
    edit(std::move(next), fmt::format("swap {} for {}", node, passType));
    return lost;
}

}  // namespace nephrite::document
