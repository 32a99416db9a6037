// Phase: offsets in the heap that Transient resources share; how many bytes all resources take, and how many
// are alive at once.
#include <algorithm>
#include <limits>

#include "graph/compiler/heap.h"
#include "graph/compiler/heap_sweep.h"
#include "graph/compiler/phases.h"

namespace nephrite::graph {
namespace {

constexpr std::uint64_t packedAlignment = 256;

/// a + b, at most the greatest 64-bit number: no machine could hold it anyway.
std::uint64_t addSaturating(std::uint64_t a, std::uint64_t b) {
    return a > std::numeric_limits<std::uint64_t>::max() - b ? std::numeric_limits<std::uint64_t>::max()
                                                             : a + b;
}

/// The Transient resources in the order of their first pass, and what they claim.
struct Claims {
    std::pmr::vector<Index> resources;
    std::pmr::vector<MemoryClaim> claims;
};

/// An unused output still is written: every resource here has a first and a last pass.
Claims makeClaims(Compilation& work) {
    Plan& plan = work.plan;
    Claims result{std::pmr::vector<Index>(work.memory()), std::pmr::vector<MemoryClaim>(work.memory())};
    result.resources.reserve(plan.resources.size());
    result.claims.reserve(plan.resources.size());
    for (const PlannedPass& pass : plan.passes) {
        const Index index = static_cast<Index>(&pass - plan.passes.data());
        for (const Index output : slice(plan.outputs, pass.outputs)) {
            Resource& resource = plan.resources[output];
            if (resource.kind != ResourceKind::Transient || resource.first != index) continue;
            MemoryNeed need{resource.bytes, packedAlignment};
            if (work.request.memory) need = work.request.memory(resource);
            resource.bytes = need.bytes;
            plan.heapUses |= resource.uses;
            result.resources.push_back(output);
            result.claims.push_back({need.bytes, need.alignment, resource.first, resource.last, resource.uses,
                                     work.levelStarts.empty() ? index : work.levelStarts[index]});
        }
    }
    return result;
}

/// Every claim beside the others.
HeapLayout placeApart(std::span<const MemoryClaim> claims, std::pmr::memory_resource* memory) {
    HeapLayout layout;
    for (const MemoryClaim& claim : claims) {
        layout.bytes = (layout.bytes + claim.alignment - 1) / claim.alignment * claim.alignment;
        layout.places.push_back({.offset = layout.bytes});
        layout.bytes += claim.bytes;
    }
    layout.peakBytes = HeapSweep(claims, memory).peakBytes();
    return layout;
}

}  // namespace

void placeInMemory(Compilation& work) {
    Plan& plan = work.plan;
    const Claims claims = makeClaims(work);
    const HeapLayout layout = work.request.plain ? placeApart(claims.claims, work.memory())
                                                 : placeInHeap(claims.claims, work.request.policy);
    plan.heapBytes = layout.bytes;
    for (std::size_t i = 0; i < claims.resources.size(); ++i) {
        Resource& resource = plan.resources[claims.resources[i]];
        resource.offset = layout.places[i].offset;
        resource.memoryUsedUntil = layout.places[i].usedUntil;
        resource.memoryUsesBefore = layout.places[i].usesBefore;
    }
    plan.peakLiveBytes = layout.peakBytes;
    for (const Resource& resource : plan.resources)
        plan.naiveBytes = addSaturating(plan.naiveBytes, resource.bytes);
}

}  // namespace nephrite::graph
