// See plan_support.h.
#include "graph/plan_support.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "graph/plan_words.h"
#include "graph/small_library.h"

namespace nephrite::graph::tests {
namespace {

PassLibrary planLibrary() {
    PassLibrary library;
    const auto add = [&](std::string name, std::string_view manifest) {
        library.add(passFrom(manifest, std::move(name)));
    };
    add("source", R"({"kind": "pixel", "shader": "s", "outputs": {"color": {"neutral": [1, 2, 3, 4]}}})");
    add("filter", R"({"kind": "pixel", "shader": "s", "inputs": {"a": {}}, "outputs": {"color": {}}})");
    add("blend", R"({"kind": "pixel", "shader": "s",
                     "inputs": {"a": {}, "b": {"optional": true, "neutral": [5, 6, 7, 8], "neededWhen": "params.useB"}},
                     "outputs": {"color": {"format": "rgba32f"}},
                     "parameters": {"useB": {"type": "bool", "default": true}}})");
    add("pair",
        R"({"kind": "compute", "shader": "s", "outputs": {"first": {}, "second": {"format": "r8"}}})");
    add("translucent", R"({"kind": "pixel", "shader": "s", "inputs": {"a": {}},
                           "outputs": {"color": {"neutral": [0, 0, 0, 1]}}, "skipWhen": "scene.translucentMaterials == 0"})");
    add("follower", R"({"kind": "pixel", "shader": "s", "inputs": {"a": {}}, "outputs": {"color": {}},
                        "skipWhen": "inputs.a.neutral"})");
    add("draw", R"({"kind": "raster", "shader": "s", "inputs": {"a": {"optional": true}},
                    "outputs": {"color": {}, "depth": {"format": "d32f"}}})");
    add("measure", R"({"kind": "compute", "shader": "s", "inputs": {"a": {}},
                       "outputs": {"sums": {"buffer": "vec3", "count": "params.count"}},
                       "parameters": {"count": {"type": "float", "default": 10}}})");
    add("summary", R"({"kind": "compute", "shader": "s", "inputs": {"sums": {"buffer": "vec3"}},
                       "outputs": {"color": {"size": [4, 2]}}})");
    add("shape", R"({"kind": "pixel", "shader": "s", "inputs": {"a": {"optional": true}},
                     "outputs": {"color": {"size": {"scale": "params.scale"}, "mips": "params.mips", "layers": "params.layers"}},
                     "parameters": {"scale": {"type": "float", "default": 1}, "mips": {"type": "float", "default": 1},
                                    "layers": {"type": "float", "default": 1}}})");
    add("second-size",
        R"({"kind": "pixel", "shader": "s", "inputs": {"a": {"optional": true}, "b": {"optional": true}},
                           "outputs": {"color": {"size": {"like": "b"}}}})");
    add("sink",
        R"({"kind": "compute", "shader": "s", "inputs": {"a": {}}, "outputs": {}, "sideEffect": true})");
    add("over", R"({"kind": "raster", "shader": "s", "inputs": {"base": {}, "a": {"optional": true}},
                    "outputs": {"color": {"modifies": "base"}}})");
    add("adjust", R"({"kind": "compute", "shader": "s", "inputs": {"base": {}, "a": {"optional": true}},
                      "outputs": {"color": {"modifies": "base"}}})");
    add("pyramid", R"({"kind": "compute", "shader": "s", "forEach": "mips", "inputs": {"a": {}},
                       "outputs": {"color": {"mips": 0, "size": {"like": "a"}}}})");
    return library;
}

std::vector<std::string> inWords(const Plan& plan, Index batch) {
    std::vector<std::string> words;
    for (const Barrier& barrier : slice(plan.schedule.barriers, plan.schedule.batches[batch])) {
        words.push_back(fmt::format("{} {} {}", plan.nameOf(plan.resources[barrier.resource]),
                                    transitionInWords(plan, barrier), dependencyInWords(barrier)));
    }
    return words;
}

Index inputIndex(const Plan& plan, const PlannedPass& pass, std::string_view input) {
    const auto& inputs = plan.typeOf(pass).inputs;
    for (Index i = 0; i < inputs.size(); ++i) {
        if (inputs[i].name == input) return i;
    }
    throw std::out_of_range(fmt::format("no input {}", input));
}

}  // namespace

CompileRequest request() {
    CompileRequest result;
    result.view = {640, 480};
    result.facts.translucentMaterials = 1;
    result.facts.pointLights = 1;
    result.facts.lightViews = 1;
    return result;
}

Plan planOf(std::string_view graph, CompileRequest compileRequest) {
    static const PassLibrary library = planLibrary();
    compileRequest.graph = link(readGraph(json::parse(std::string(graph), "g.json")), library);
    return compile(compileRequest);
}

std::vector<std::string> faultsOf(std::string_view graph, CompileRequest compileRequest) {
    std::vector<std::string> lines;
    try {
        planOf(graph, std::move(compileRequest));
    } catch (const InputError& error) {
        for (const Diagnostic& fault : error.faults()) lines.push_back(toLine(fault));
    }
    return lines;
}

Index nodeNamed(const Plan& plan, std::string_view name) {
    const auto& nodes = plan.graph->description.nodes;
    const auto found =
        std::find_if(nodes.begin(), nodes.end(), [&](const auto& node) { return node.name == name; });
    if (found == nodes.end()) throw std::out_of_range(fmt::format("no node {}", name));
    return static_cast<Index>(found - nodes.begin());
}

NodeState stateOf(const Plan& plan, std::string_view node) {
    return plan.nodes[nodeNamed(plan, node)].state;
}

std::string whyOf(const Plan& plan, std::string_view node) {
    return graph::whyOf(plan, nodeNamed(plan, node));
}

std::vector<std::string> passNames(const Plan& plan) {
    std::vector<std::string> names;
    for (const PlannedPass& pass : plan.passes) names.push_back(plan.nameOf(pass));
    return names;
}

const PlannedPass& passNamed(const Plan& plan, std::string_view node) {
    const auto found = std::find_if(plan.passes.begin(), plan.passes.end(),
                                    [&](const PlannedPass& pass) { return plan.nameOf(pass) == node; });
    if (found == plan.passes.end()) throw std::out_of_range(fmt::format("no pass {}", node));
    return *found;
}

const InputRead& inputOf(const Plan& plan, std::string_view node, std::string_view input) {
    const PlannedPass& pass = passNamed(plan, node);
    return plan.inputs[pass.inputs.first + inputIndex(plan, pass, input)];
}

const Resource& resourceNamed(const Plan& plan, std::string_view name) {
    const auto found = std::find_if(plan.resources.begin(), plan.resources.end(),
                                    [&](const Resource& resource) { return plan.nameOf(resource) == name; });
    if (found == plan.resources.end()) throw std::out_of_range(fmt::format("no resource {}", name));
    return *found;
}

std::array<double, 4> neutralOf(const Plan& plan, std::string_view node, std::string_view input) {
    const PlannedPass& pass = passNamed(plan, node);
    return graph::neutralOf(plan, pass, inputIndex(plan, pass, input));
}

std::vector<std::string> barriersBefore(const Plan& plan, std::string_view node, Index iteration) {
    return inWords(plan, passNamed(plan, node).firstBatch + iteration);
}

std::vector<std::string> barriersAtEnd(const Plan& plan) {
    return inWords(plan, static_cast<Index>(plan.schedule.batches.size() - 1));
}

std::vector<std::string> barriersOf(const Plan& plan, std::string_view resource) {
    std::vector<std::string> all;
    for (Index batch = 0; batch < plan.schedule.batches.size(); ++batch) {
        for (std::string& words : inWords(plan, batch)) {
            if (words.starts_with(std::string(resource) + ' ')) all.push_back(std::move(words));
        }
    }
    return all;
}

}  // namespace nephrite::graph::tests
