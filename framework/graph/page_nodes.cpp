// The nodes of a plan's page: what became of each and why, its ports, its times and pictures.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

#include "graph/explain.h"
#include "graph/page_data.h"
#include "graph/plan_words.h"
#include "text/base64.h"

namespace nephrite::graph {
namespace {

class NodeWriter {
  public:
    NodeWriter(const PageSource& source, const DrawnNode& drawn)
        : plan_(source.plan),
          measurements_(source.measurements),
          drawn_(drawn),
          node_(drawn.node),
          pass_(node_ == noIndex ? noIndex : source.passes[node_]) {}

    Json::Value write() {
        addBox();
        if (node_ == noIndex) {
            addRequested();
        } else {
            addNode();
            addInputs();
            addOutputs();
            addWords();
        }
        if (pass_ != noIndex) addPass();
        return std::move(json_);
    }

  private:
    const PlannedPass& pass() const { return plan_.passes[pass_]; }
    const LinkedNode& linked() const { return plan_.graph->nodes[node_]; }

    void addBox() {
        for (const float value : {drawn_.corner.x, drawn_.corner.y, drawn_.width, drawn_.height})
            json_["box"].append(value);
        json_["inputs"] = Json::arrayValue;
        json_["outputs"] = Json::arrayValue;
        json_["words"] = Json::arrayValue;
    }

    void addRequested() {
        const RequestedOutput& output = plan_.requested[drawn_.requested];
        json_["name"] = output.name;
        json_["type"] = "output";
        json_["state"] = "output";
        json_["why"] = "it was asked for";
        addInput(output.name, 0)["resource"] = output.resource;
    }

    void addNode() {
        json_["name"] = plan_.graph->nodeName(node_);
        json_["type"] = linked().type->name;
        json_["kind"] = std::string(graph::name(linked().type->kind));
        json_["doc"] = linked().type->doc;
        json_["state"] = stateInWords();
        json_["why"] = whyOf(plan_, node_);
    }

    std::string stateInWords() const {
        if (linked().role == NodeRole::Import) return "import";
        if (pass_ != noIndex && plan_.nodes[node_].state == NodeState::Run && keepsResults(plan_, pass()))
            return "kept";
        return std::string(graph::name(plan_.nodes[node_].state));
    }

    Json::Value& addInput(const std::string& name, Index row) {
        Json::Value input;
        input["name"] = name;
        input["y"] = drawn_.inputs[row].y - drawn_.corner.y;
        return json_["inputs"].append(std::move(input));
    }

    void addInputs() {
        const auto& ports = linked().type->inputs;
        const auto sources = slice(plan_.graph->inputs, linked().inputs);
        for (Index port = 0; port < ports.size(); ++port) {
            Json::Value& input = addInput(ports[port].name, port);
            input["doc"] = ports[port].doc;
            if (sources[port].sourceNode != noIndex)
                input["source"] = plan_.graph->portName(sources[port].sourceNode, sources[port].sourcePort);
            if (pass_ != noIndex) addRead(plan_.inputs[pass().inputs.first + port], port, input);
        }
        if (drawn_.inputs.size() > ports.size())
            addInput("tiles", static_cast<Index>(ports.size()))["resource"] = pass().tileList;
    }

    void addRead(const InputRead& read, Index port, Json::Value& input) const {
        if (read.resource == noIndex) {
            input["constant"] = fmt::format("{}", fmt::join(neutralOf(plan_, pass(), port), " "));
            return;
        }
        input["resource"] = read.resource;
        std::vector<std::string> details;
        if (read.mip != every) details.push_back(fmt::format("level {}", read.mip));
        if (read.layer != every) details.push_back(fmt::format("layer {}", read.layer));
        if (read.modified) details.emplace_back("modified in place");
        if (!details.empty()) input["detail"] = fmt::format("{}", fmt::join(details, ", "));
    }

    void addOutputs() {
        const auto& ports = linked().type->outputs;
        for (Index port = 0; port < ports.size(); ++port) {
            Json::Value output;
            output["name"] = ports[port].name;
            output["doc"] = ports[port].doc;
            output["y"] = drawn_.outputs[port].y - drawn_.corner.y;
            output["format"] = declaredFormat(*plan_.graph, node_, port);
            if (pass_ != noIndex) output["resource"] = plan_.outputs[pass().outputs.first + port];
            addPicture(linked().formats.first + port, output);
            json_["outputs"].append(std::move(output));
        }
    }

    void addPicture(Index port, Json::Value& output) const {
        if (port >= measurements_.pictures.size() || measurements_.pictures[port].png.empty()) return;
        output["picture"] = "data:image/png;base64," + base64(measurements_.pictures[port].png);
        output["scale"] = measurements_.pictures[port].scale;
    }

    /// What `--why` says, less its first line, which the page has elsewhere.
    void addWords() {
        std::istringstream lines(explain(plan_, plan_.graph->nodeName(node_)));
        std::string line;
        std::getline(lines, line);
        while (std::getline(lines, line)) json_["words"].append(line.substr(line.find_first_not_of(' ')));
    }

    void addPass() {
        json_["pass"] = pass_;
        json_["iterations"] = pass().iterations;
        std::uint64_t bytes = 0;
        for (const Index output : slice(plan_.outputs, pass().outputs)) {
            const Resource& resource = plan_.resources[output];
            if (resource.node == node_) bytes += resource.bytes;  // what others only modify counts once
        }
        json_["bytes"] = bytes;
        if (pass_ >= measurements_.passes.size()) return;
        const PassFigures& figures = measurements_.passes[pass_];
        json_["gpuMs"] = figures.gpuMs;
        json_["cpuMs"] = figures.cpuMs;
        json_["rests"] = figures.rests;
    }

    const Plan& plan_;
    const PlanMeasurements& measurements_;
    const DrawnNode& drawn_;
    Index node_;
    Index pass_;
    Json::Value json_;
};

}  // namespace

Json::Value nodesAsJson(const PageSource& source) {
    Json::Value nodes(Json::arrayValue);
    for (const DrawnNode& drawn : source.drawing.nodes) nodes.append(NodeWriter(source, drawn).write());
    return nodes;
}

}  // namespace nephrite::graph
