// See plan_oracle_figures.h.
#include "graph/plan_oracle_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "graph/plan_oracle_memory.h"

namespace nephrite::graph::tests {
namespace {

class FigureCheck {
  public:
    FigureCheck(const CompileRequest& request, const Plan& plan, std::vector<std::string>& findings)
        : request_(request), plan_(plan), findings_(findings), writers_(plan.resources.size(), 0) {
        for (const Index output : plan.outputs) {
            if (output != noIndex) ++writers_[output];
        }
    }

    void check() {
        for (const Resource& resource : plan_.resources) {
            checkPlace(resource);
            checkKind(resource);
        }
        checkTotals();
    }

  private:
    void report(const Resource& resource, const std::string& what) {
        findings_.push_back(plan_.nameOf(resource) + ": " + what);
    }

    void checkPlace(const Resource& resource) {
        const bool isTransient = resource.kind == ResourceKind::Transient;
        if (isTransient != (resource.offset != Resource::noOffset))
            report(resource, "is in the heap and not transient, or the other way round");
        if (!isTransient) return;
        if (resource.first > resource.last || resource.last >= plan_.passes.size()) {
            report(resource, "has no life");
            isCountable_ = false;
        }
        if (resource.offset + resource.bytes > plan_.heapBytes) report(resource, "ends behind the heap");
        const MemoryNeed need = request_.memory ? request_.memory(resource) : MemoryNeed{resource.bytes, 256};
        if (resource.bytes != need.bytes) report(resource, fmt::format("has {} bytes", resource.bytes));
        if (resource.offset % need.alignment != 0) report(resource, "is not aligned");
    }

    void checkKind(const Resource& resource) {
        const bool isImport = request_.graph->nodes[resource.node].role == NodeRole::Import;
        if (isImport != (resource.kind == ResourceKind::Imported) && resource.kind != ResourceKind::History)
            report(resource, "is an import and not imported, or the other way round");
        if (resource.kind == ResourceKind::Imported) checkImport(resource);
        if (resource.kind != ResourceKind::Imported && resource.importedUses != 0)
            report(resource, "waits for an owner outside");
        if (resource.kind == ResourceKind::Kept && request_.keep == Keep::Nothing)
            report(resource, "is kept");
        checkKept(resource);
        const bool rests = resource.kind == ResourceKind::Kept || resource.kind == ResourceKind::History;
        if (rests && resource.initial != resource.final) report(resource, "does not end as it starts");
        if (rests && !resource.isBuffer && resource.final == Layout::Undefined)
            report(resource, "loses its contents");
        if (resource.kind == ResourceKind::Transient &&
            (resource.initial != Layout::Undefined || resource.final != Layout::Undefined))
            report(resource, "is transient and has a layout between frames");
    }

    /// What several passes write in turn cannot outlast the frame, as a pass left out would find it changed.
    void checkKept(const Resource& resource) {
        const auto index = static_cast<std::size_t>(&resource - plan_.resources.data());
        const bool mayBeKept = request_.keep != Keep::Nothing && writers_[index] == 1;
        if (resource.kind == ResourceKind::Kept && !mayBeKept) report(resource, "is kept");
        if (resource.kind == ResourceKind::Transient && mayBeKept && request_.keep == Keep::Everything)
            report(resource, "is not kept");
    }

    void checkImport(const Resource& resource) {
        const ImportedImage& image = request_.imports[request_.graph->nodes[resource.node].import];
        if (resource.extent != image.extent || resource.mips != image.mips || resource.layers != image.layers)
            report(resource, "has another size than what is imported");
        if (resource.importedUses != image.usesBefore)
            report(resource, "forgets what its owner may still do");
        if (resource.initial != image.initial) report(resource, "arrives in another layout");
        if (resource.final != image.final) report(resource, "is wanted back in another layout");
    }

    void checkTotals() {
        if (!isCountable_) return;
        std::uint64_t naive = 0;
        std::vector<std::uint64_t> grows(plan_.passes.size() + 1, 0);
        std::vector<std::uint64_t> shrinks(grows);
        for (const Resource& resource : plan_.resources) {
            naive += resource.bytes;
            if (resource.kind != ResourceKind::Transient) continue;
            grows[resource.first] += resource.bytes;
            shrinks[resource.last + 1] += resource.bytes;
        }
        std::uint64_t live = 0;
        std::uint64_t peak = 0;
        for (std::size_t pass = 0; pass < plan_.passes.size(); ++pass) {
            live = live + grows[pass] - shrinks[pass];
            peak = std::max(peak, live);
        }
        if (plan_.naiveBytes != naive) findings_.push_back(fmt::format("naiveBytes is not {}", naive));
        if (plan_.peakLiveBytes != peak) findings_.push_back(fmt::format("peakLiveBytes is not {}", peak));
        if (plan_.heapBytes < peak) findings_.push_back("the heap is smaller than what is alive at once");
    }

    const CompileRequest& request_;
    const Plan& plan_;
    std::vector<std::string>& findings_;
    std::vector<Index> writers_;  ///< by resource: how many passes write it
    bool isCountable_ = true;     ///< every life lies within the frame
};

}  // namespace

void checkOverlaps(const Plan& plan, std::vector<std::string>& findings) {
    const HeapOwners heap(plan);
    std::vector<Index> inOrder(plan.resources.size());
    std::iota(inOrder.begin(), inOrder.end(), Index{0});
    std::stable_sort(inOrder.begin(), inOrder.end(),
                     [&](Index a, Index b) { return plan.resources[a].first < plan.resources[b].first; });
    std::vector<Index> latest(heap.pieceCount(), noIndex);  // by piece: the resource that lived in it last
    for (const Index index : inOrder) {
        const Range pieces = heap.piecesOf(index);
        const Resource& resource = plan.resources[index];
        for (Index piece = pieces.first; piece < pieces.first + pieces.count; ++piece) {
            const Index other = latest[piece];
            if (other != noIndex && plan.resources[other].last >= resource.first) {
                findings.push_back(fmt::format("{} and {} are alive at once in the same bytes",
                                               plan.nameOf(resource), plan.nameOf(plan.resources[other])));
                break;
            }
            latest[piece] = index;
        }
    }
}

void checkFigures(const CompileRequest& request, const Plan& plan, std::vector<std::string>& findings) {
    FigureCheck(request, plan, findings).check();
}

}  // namespace nephrite::graph::tests
