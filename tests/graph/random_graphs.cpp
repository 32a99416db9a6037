// See random_graphs.h.
#include "graph/random_graphs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "graph/random_nodes.h"

namespace nephrite::graph::tests {
namespace {

/// A linked graph and the pass types that it points to.
struct Linked {
    PassLibrary library;
    std::shared_ptr<const LinkedGraph> graph;
};

class RandomRequest {
  public:
    RandomRequest(std::uint64_t seed, Index mostNodes) : chance_(seed), seed_(seed), mostNodes_(mostNodes) {}

    CompileRequest make() {
        request_.view = {1 + chance_.below(64), 1 + chance_.below(64)};
        request_.facts.lightViews = chance_.below(3);
        request_.facts.translucentMaterials = chance_.below(2);
        RandomNodes nodes(chance_, request_.facts.lightViews);
        addImports(nodes);
        const Index count = 1 + chance_.below(mostNodes_);
        for (Index i = 0; i < count; ++i) nodes.add();
        addHistory(nodes);
        addRequests(nodes);
        linkNodes(nodes);
        chooseSettings();
        return std::move(request_);
    }

  private:
    void addImports(RandomNodes& nodes) {
        static constexpr std::array layouts{Layout::General, Layout::ShaderRead, Layout::ColorAttachment,
                                            Layout::TransferSource, Layout::TransferDestination};
        static constexpr std::array pending{Uses{0}, bit(Use::ComputeRead), bit(Use::ColorAttachment),
                                            bit(Use::ComputeWrite) | bit(Use::RasterRead)};
        for (Index i = chance_.oneIn(2) ? 0 : 1 + chance_.below(2); i > 0; --i) {
            ImportedImage image;
            image.extent = {1 + chance_.below(40), 1 + chance_.below(40)};
            if (chance_.oneIn(3)) image.mips = mostMips(image.extent);
            if (chance_.oneIn(3)) image.layers = 1 + chance_.below(3);
            image.initial = chance_.oneOf(layouts);
            image.usesBefore = chance_.oneOf(pending);
            if (chance_.oneIn(2)) image.final = chance_.oneOf(layouts);
            nodes.addImport(image);
            request_.imports.push_back(image);
        }
    }

    /// Inputs that read earlier frames, also of later nodes and of their own.
    void addHistory(RandomNodes& nodes) {
        if (chance_.oneIn(2)) return;
        for (Index i = 1 + chance_.below(3); i > 0; --i) nodes.addPrevious(1 + chance_.below(3));
    }

    void addRequests(RandomNodes& nodes) {
        for (Index i = 1 + chance_.below(3); i > 0; --i) {
            const PortReference port = nodes.askFor();
            if (nodes.description.outputs.empty() || chance_.oneIn(2)) {
                nodes.description.outputs.emplace_back(fmt::format("output{}", i), port);
            } else {
                request_.dumps.push_back(port);
            }
        }
    }

    void linkNodes(RandomNodes& nodes) {
        const auto linked = std::make_shared<Linked>();
        for (PassType& type : nodes.types) linked->library.add(std::move(type));
        // The file's order says nothing: sources may stand after their readers.
        if (chance_.oneIn(2)) {
            auto& all = nodes.description.nodes;
            for (std::size_t i = all.size(); i > 1; --i)
                std::swap(all[i - 1], all[chance_.below(static_cast<std::uint32_t>(i))]);
        }
        linked->graph = link(std::move(nodes.description), linked->library);
        request_.graph = {linked, linked->graph.get()};
    }

    void chooseSettings() {
        request_.inputReads = chance_.oneIn(2) ? InputReads::StorageImage : InputReads::SampledImage;
        request_.skip = !chance_.oneIn(4);
        request_.policy = chance_.oneIn(3) ? Policy::Memory : Policy::Barriers;
        request_.keep = static_cast<Keep>(chance_.below(3));
        if (chance_.oneIn(2)) {
            for (std::size_t i = 0; i < request_.graph->nodes.size(); ++i)
                request_.dependsOn.push_back(chance_.below(64) & chance_.below(64));
        }
        if (chance_.oneIn(2)) request_.memory = randomNeeds(seed_);
    }

    /// Alignments from 16 bytes to 64 KiB, the same for the same resource.
    static std::function<MemoryNeed(const Resource&)> randomNeeds(std::uint64_t seed) {
        return [seed](const Resource& resource) {
            const std::uint64_t mixed = (seed + resource.node * 7 + resource.port) * 0x9e3779b97f4a7c15U;
            const std::uint64_t alignment = std::uint64_t{16} << (mixed >> 40) % 13;
            return MemoryNeed{(resource.bytes + alignment - 1) / alignment * alignment, alignment};
        };
    }

    Chance chance_;
    std::uint64_t seed_;
    Index mostNodes_;
    CompileRequest request_;
};

/// Whether a later frame finds all that the pass wrote and anybody reads.
bool isKept(const Plan& plan, const PlannedPass& pass) {
    const auto outputs = slice(plan.outputs, pass.outputs);
    return std::all_of(outputs.begin(), outputs.end(), [&](Index output) {
        if (output == noIndex) return true;
        const Resource& resource = plan.resources[output];
        const bool isUnread = resource.first == resource.last && !resource.requested;
        return resource.kind == ResourceKind::Kept || (resource.kind == ResourceKind::Transient && isUnread);
    });
}

}  // namespace

CompileRequest randomRequest(std::uint64_t seed, Index mostNodes) {
    return RandomRequest(seed, mostNodes).make();
}

std::vector<std::uint8_t> randomRuns(const Plan& plan, std::uint64_t seed) {
    Chance chance(seed);
    std::vector<std::uint8_t> runs(plan.passes.size(), 1);
    std::vector<std::uint8_t> isWritten(plan.resources.size(), 0);  // by a pass that runs
    const auto note = [&](std::size_t pass) {
        for (const Index output : slice(plan.outputs, plan.passes[pass].outputs)) {
            if (output != noIndex) isWritten[output] = 1;
        }
    };
    const auto sharesWriter = [&](std::size_t pass) {
        const auto outputs = slice(plan.outputs, plan.passes[pass].outputs);
        return std::any_of(outputs.begin(), outputs.end(),
                           [&](Index output) { return output != noIndex && isWritten[output] != 0; });
    };
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const PlannedPass& pass = plan.passes[i];
        if (!pass.outputs.count || !isKept(plan, pass) || chance.oneIn(2)) {
            note(i);
        } else {
            runs[i] = 0;
        }
    }
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < runs.size(); ++i) {
            if (runs[i] != 0 || !sharesWriter(i)) continue;
            runs[i] = 1;
            note(i);
            changed = true;
        }
    }
    return runs;
}

}  // namespace nephrite::graph::tests
