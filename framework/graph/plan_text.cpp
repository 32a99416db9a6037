// A plan for people: passes in order, and under each its barriers, what it reads and what it writes.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "graph/plan_words.h"
#include "graph/plan_writer.h"

namespace nephrite::graph {
namespace {

/// Rows of cells, printed with aligned columns.
class Table {
  public:
    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

    void appendTo(std::string& text, std::string_view indent) const {
        std::vector<std::size_t> widths;
        for (const auto& row : rows_) {
            widths.resize(std::max(widths.size(), row.size()));
            for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
        }
        for (const auto& row : rows_) {
            std::string line(indent);
            for (std::size_t i = 0; i < row.size(); ++i) {
                line += row[i];
                line.append(widths[i] - row[i].size() + 2, ' ');
            }
            line.erase(line.find_last_not_of(' ') + 1);
            text += line + "\n";
        }
    }

  private:
    std::vector<std::vector<std::string>> rows_;
};

/// Images from outside are not run, and lists of tiles that nobody needs are of no interest.
std::size_t countOf(const Plan& plan, NodeState state) {
    std::size_t count = 0;
    for (Index node = 0; node < plan.nodes.size(); ++node) {
        const NodeRole role = plan.graph->nodes[node].role;
        const bool isListed =
            role == NodeRole::Pass || (role == NodeRole::TileList && state == NodeState::Run);
        if (isListed && plan.nodes[node].state == state) ++count;
    }
    return count;
}

std::size_t sharingResources(const Plan& plan) {
    return static_cast<std::size_t>(
        std::count_if(plan.resources.begin(), plan.resources.end(),
                      [](const Resource& resource) { return resource.kind == ResourceKind::Transient; }));
}

std::string summary(const Plan& plan) {
    std::string text = fmt::format("plan of {} at {} x {}, ordered for {}\n", plan.graph->description.name,
                                   plan.view.width, plan.view.height, name(plan.policy));
    text += fmt::format("{} passes run, {} skipped, {} culled\n", countOf(plan, NodeState::Run),
                        countOf(plan, NodeState::Skipped), countOf(plan, NodeState::Culled));
    text +=
        fmt::format("{} resources take {} apart; {} share a heap of {}, at most {} of it in use at once\n",
                    plan.resources.size(), bytesInWords(plan.naiveBytes), sharingResources(plan),
                    bytesInWords(plan.heapBytes), bytesInWords(plan.peakLiveBytes));
    text += fmt::format("{} barriers in {} batches; one for each use would be {}\n",
                        plan.schedule.barriers.size(), plan.schedule.batchCount, plan.naiveBarriers);
    if (plan.otherPolicy)
        text += fmt::format("ordered for {} it would be {} batches and a heap of {}\n",
                            name(plan.otherPolicy->policy), plan.otherPolicy->barrierBatches,
                            bytesInWords(plan.otherPolicy->heapBytes));
    text += fmt::format(
        "left out: {} not needed, {} neutral; can be left out: {} while unchanged, {} outside their domain; "
        "{} specialised\n",
        plan.skips.notNeeded, plan.skips.neutral, plan.skips.keepable, plan.skips.tiled,
        plan.skips.specialized);
    return text;
}

void addBarriers(const Plan& plan, Range range, Table& table) {
    for (const Barrier& barrier : slice(plan.schedule.barriers, range)) {
        table.add({"barrier", plan.nameOf(plan.resources[barrier.resource]), transitionInWords(plan, barrier),
                   dependencyInWords(barrier)});
    }
}

std::string readInWords(const Plan& plan, const PlannedPass& pass, Index port) {
    const InputRead& read = plan.inputs[pass.inputs.first + port];
    if (read.resource == noIndex)
        return fmt::format("constant {}", fmt::join(neutralOf(plan, pass, port), " "));
    std::string words = "from " + plan.nameOf(plan.resources[read.resource]);
    if (read.mip != every) words += fmt::format(", level {}", read.mip);
    if (read.layer != every) words += fmt::format(", layer {}", read.layer);
    if (read.modified) words += ", modified in place";
    return words;
}

void addReads(const Plan& plan, const PlannedPass& pass, Table& table) {
    for (Index port = 0; port < pass.inputs.count; ++port)
        table.add({"read", plan.typeOf(pass).inputs[port].name, readInWords(plan, pass, port)});
    if (pass.tileList != noIndex)
        table.add({"tiles", "", "from " + plan.nameOf(plan.resources[pass.tileList])});
}

void addWrites(const Plan& plan, const PlannedPass& pass, Table& table) {
    for (Index port = 0; port < pass.outputs.count; ++port) {
        const Resource& resource = plan.resources[plan.outputs[pass.outputs.first + port]];
        table.add({pass.iterations == 0 ? "clear" : "write", plan.typeOf(pass).outputs[port].name,
                   formatName(plan, resource), sizeInWords(resource), bytesInWords(resource.bytes),
                   fmt::format("passes {} to {}, {}{}", resource.first, resource.last, placeInWords(resource),
                               resource.requested ? ", requested" : "")});
    }
}

std::string nodeLine(const Plan& plan, Index node) {
    const PassType& type = *plan.graph->nodes[node].type;
    return fmt::format("{}  [{} {}]  {}: {}", plan.graph->nodeName(node), name(type.kind), type.name,
                       name(plan.nodes[node].state), whyOf(plan, node));
}

void appendPass(const Plan& plan, Index index, std::string& text) {
    const PlannedPass& pass = plan.passes[index];
    text += fmt::format("\n{:>4}  {}\n", index, nodeLine(plan, pass.node));
    if (pass.iterations > 1)
        text += fmt::format("      {} iterations, one a {}\n", pass.iterations,
                            pass.forEach == ForEach::Mips ? "level" : "light view");
    Table barriers, reads, writes;
    for (Index batch = 0; batch < pass.batchCount(); ++batch)
        addBarriers(plan, plan.schedule.batches[pass.firstBatch + batch], barriers);
    addReads(plan, pass, reads);
    addWrites(plan, pass, writes);
    for (const Table* table : {&barriers, &reads, &writes}) table->appendTo(text, "      ");
}

void appendRequested(const Plan& plan, std::string& text) {
    text += "\n      copied out after the last pass\n";
    Table barriers, outputs;
    addBarriers(plan, plan.schedule.batches.back(), barriers);
    for (const RequestedOutput& output : plan.requested) {
        outputs.add({"output", output.name,
                     output.resource == noIndex ? "constant"
                                                : "from " + plan.nameOf(plan.resources[output.resource])});
    }
    for (const Table* table : {&barriers, &outputs}) table->appendTo(text, "      ");
}

}  // namespace

std::string planAsText(const Plan& plan) {
    std::string text = summary(plan);
    for (Index i = 0; i < plan.passes.size(); ++i) appendPass(plan, i, text);
    appendRequested(plan, text);
    const std::vector<Index> nodes = nodesInReportOrder(plan);
    if (nodes.size() > plan.passes.size()) text += "\nnot run\n";
    for (std::size_t i = plan.passes.size(); i < nodes.size(); ++i) {
        text += fmt::format("      {}\n", nodeLine(plan, nodes[i]));
    }
    return text;
}

}  // namespace nephrite::graph
