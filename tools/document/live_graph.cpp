// See live_graph.h.
#include "document/live_graph.h"

#include <fmt/format.h>

#include <utility>

#include "graph/controls.h"
#include "text/json_difference.h"

namespace nephrite::document {
namespace {

bool isBinding(const std::optional<json::Value>& value) {
    return value && value->isString();
}

/// Whether a parameter that has one value can have the other without being declared anew.
bool haveOneShape(const std::optional<json::Value>& a, const std::optional<json::Value>& b) {
    if (!a || !b) return true;
    return a->isArray() == b->isArray() && a->isBool() == b->isBool() && a->size() == b->size();
}

/// What a parameter is called in a setting, or nothing if the path is not that of a parameter's value.
std::optional<std::string> targetAt(const json::Path& path) {
    if (path.size() == 3 && path[0] == "parameters" && path[2] == "value") return path[1];
    if (path.size() == 4 && path[0] == "nodes" && path[2] == "set") return path[1] + "." + path[3];
    return std::nullopt;
}

/// Where the one value stands in which the documents differ, or nothing if they differ in more.
std::optional<json::Path> onlyChange(const json::Value& before, const json::Value& after) {
    const std::vector<json::Change> changes = json::differences(before, after);
    if (changes.size() != 1) return std::nullopt;
    json::Path path = changes[0].path;
    // With the last setting its object goes.
    const bool isSettings = path.size() == 3 && path[0] == "nodes" && path[2] == "set";
    if (!isSettings || changes[0].json) return path;
    const auto settings = json::findAt(before, path)->members();
    if (settings.size() != 1) return std::nullopt;
    path.push_back(settings[0].first);
    return path;
}

/// The manifest's value of a node's parameter, as JSON.
std::string defaultOf(const graph::LinkedGraph& graph, const std::string& target) {
    for (const graph::NodeControls& node : graph::controlsOf(graph, graph.values).nodes) {
        for (const graph::Control& control : node.parameters) {
            if (control.target == target) return graph::valueText(control, control.defaultValue);
        }
    }
    return {};
}

bool areTheSame(const Extras& a, const Extras& b) {
    if (a.dumps != b.dumps || a.display.has_value() != b.display.has_value()) return false;
    return !a.display || (a.display->port == b.display->port && a.display->reference == b.display->reference);
}

}  // namespace

runtime::GraphSource sourceOf(const GraphDocument& document, Extras extras) {
    runtime::GraphSource source;
    source.file = document.file();
    source.dumps = std::move(extras.dumps);
    source.display = std::move(extras.display);
    source.text = document.text();
    return source;
}

std::optional<std::string> settingBetween(const graph::LinkedGraph& graph, const json::Value& before,
                                          const json::Value& after) {
    const std::optional<json::Path> path = onlyChange(before, after);
    const std::optional<std::string> target = path ? targetAt(*path) : std::nullopt;
    if (!target) return std::nullopt;
    const std::optional<json::Value> old = json::findAt(before, *path);
    const std::optional<json::Value> now = json::findAt(after, *path);
    if (isBinding(old) || isBinding(now) || !haveOneShape(old, now)) return std::nullopt;
    return fmt::format("{}={}", *target, now ? std::string(now->sourceText()) : defaultOf(graph, *target));
}

LiveGraph::LiveGraph(runtime::Session& session, const GraphDocument& shown, Extras extras)
    : session_(session), graph_(shown.graph()), root_(shown.root()), extras_(std::move(extras)) {}

bool LiveGraph::show(const GraphDocument& document, const Extras& extras) {
    const bool hasExtras = areTheSame(extras, extras_);
    const bool isShown = document.text() == root_.document().text && hasExtras;
    if (!isShown) {
        const auto setting = hasExtras ? settingBetween(*graph_, root_, document.root()) : std::nullopt;
        if (setting) {
            session_.set(*setting);
        } else {
            session_.setGraph(sourceOf(document, extras));
        }
    }
    graph_ = document.graph();
    root_ = document.root();
    extras_ = extras;
    return !isShown;
}

}  // namespace nephrite::document
