// Placement in the heap, held against definitions: what is alive at once lies apart, and a claim knows who
// used its bytes before.
#include "graph/compiler/heap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace nephrite::graph::tests {
namespace {

constexpr Policy policies[]{Policy::Barriers, Policy::Memory};

bool overlapInTime(const MemoryClaim& a, const MemoryClaim& b) {
    return a.first <= b.last && b.first <= a.last;
}

bool overlapInMemory(const MemoryClaim& a, std::uint64_t offsetA, const MemoryClaim& b,
                     std::uint64_t offsetB) {
    return a.bytes > 0 && b.bytes > 0 && offsetA < offsetB + b.bytes && offsetB < offsetA + a.bytes;
}

/// The most bytes alive in any one pass.
std::uint64_t peakOf(const std::vector<MemoryClaim>& claims) {
    std::uint64_t peak = 0;
    for (const MemoryClaim& moment : claims) {
        std::uint64_t alive = 0;
        for (const MemoryClaim& claim : claims) {
            if (claim.first <= moment.first && moment.first <= claim.last) alive += claim.bytes;
        }
        peak = std::max(peak, alive);
    }
    return peak;
}

/// Whether `later` comes to life after `earlier` and nobody who lies over the same bytes comes between them.
bool isDirectlyBefore(const std::vector<MemoryClaim>& claims, const HeapLayout& layout, std::size_t earlier,
                      std::size_t later) {
    const auto over = [&](std::size_t a, std::size_t b) {
        return overlapInMemory(claims[a], layout.places[a].offset, claims[b], layout.places[b].offset);
    };
    if (claims[earlier].last >= claims[later].first || !over(earlier, later)) return false;
    for (std::size_t i = 0; i < claims.size(); ++i) {
        const bool between = claims[i].first > claims[earlier].last && claims[i].last < claims[later].first;
        if (between && over(i, earlier) && over(i, later)) return false;
    }
    return true;
}

void expectSound(const std::vector<MemoryClaim>& claims, const HeapLayout& layout) {
    ASSERT_EQ(layout.places.size(), claims.size());
    for (std::size_t a = 0; a < claims.size(); ++a) {
        const MemoryPlace& place = layout.places[a];
        EXPECT_EQ(place.offset % claims[a].alignment, 0U);
        EXPECT_LE(place.offset + claims[a].bytes, layout.bytes);
        for (std::size_t b = 0; b < a; ++b) {
            EXPECT_FALSE(overlapInTime(claims[a], claims[b]) &&
                         overlapInMemory(claims[a], place.offset, claims[b], layout.places[b].offset))
                << "claims " << b << " and " << a;
        }
    }
}

void expectPast(const std::vector<MemoryClaim>& claims, const HeapLayout& layout) {
    for (std::size_t a = 0; a < claims.size(); ++a) {
        const MemoryPlace& place = layout.places[a];
        EXPECT_TRUE(place.usedUntil == noIndex || place.usedUntil < claims[a].first);
        for (std::size_t b = 0; b < claims.size(); ++b) {
            if (!isDirectlyBefore(claims, layout, b, a)) continue;
            ASSERT_NE(place.usedUntil, noIndex) << "claim " << a << " lies over " << b;
            EXPECT_GE(place.usedUntil, claims[b].last);
            EXPECT_EQ(place.usesBefore & claims[b].uses, claims[b].uses);
        }
    }
}

/// `count` claims over as many passes, alive for up to `longest` passes.
std::vector<MemoryClaim> randomClaims(std::uint64_t seed, Index count, Index longest) {
    std::mt19937_64 random(seed);
    const auto below = [&](std::uint64_t bound) { return static_cast<Index>(random() % bound); };
    std::vector<MemoryClaim> claims(count);
    for (MemoryClaim& claim : claims) {
        claim.bytes = below(8) == 0 ? below(3) : 1 + below(100000);
        claim.alignment = std::uint64_t{1} << below(10);
        claim.first = below(count);
        claim.last = std::min(count - 1, claim.first + below(longest));
        claim.uses = 1U << below(10);
    }
    return claims;
}

TEST(Heap, OfNothingIsEmpty) {
    for (const Policy policy : policies) EXPECT_EQ(placeInHeap({}, policy).bytes, 0U);
}

TEST(Heap, AResourceOfNoBytesTakesNone) {
    const std::vector<MemoryClaim> claims{{0, 256, 0, 3, 1}, {256, 256, 0, 3, 2}};
    for (const Policy policy : policies) {
        const HeapLayout layout = placeInHeap(claims, policy);
        EXPECT_EQ(layout.bytes, 256U);
        expectSound(claims, layout);
    }
}

TEST(Heap, ASecondResourceTakesTheMemoryOfADeadOne) {
    const std::vector<MemoryClaim> claims{
        {1024, 256, 0, 1, 1}, {1024, 256, 0, 4, 2}, {1024, 256, 2, 3, 4, 2}};
    for (const Policy policy : policies) {
        const HeapLayout layout = placeInHeap(claims, policy);
        EXPECT_EQ(layout.bytes, 2048U);
        EXPECT_EQ(layout.places[0].usedUntil, noIndex);
        EXPECT_EQ(layout.places[2].usedUntil, 1U);
        EXPECT_EQ(layout.places[2].usesBefore, 1U);
    }
}

TEST(Heap, ResourcesOfOnePassNeverShare) {
    const std::vector<MemoryClaim> claims{{512, 256, 0, 2, 1}, {512, 256, 2, 2, 1}, {512, 256, 2, 4, 1}};
    for (const Policy policy : policies) EXPECT_EQ(placeInHeap(claims, policy).bytes, 3U * 512);
}

TEST(Heap, DeadNeighboursTogetherHoldALargeResource) {
    const std::vector<MemoryClaim> claims{{256, 256, 0, 0, 1}, {512, 256, 0, 1, 2}, {768, 256, 2, 2, 4}};
    for (const Policy policy : policies) {
        const HeapLayout layout = placeInHeap(claims, policy);
        EXPECT_EQ(layout.bytes, 768U);
        EXPECT_EQ(layout.places[2].usedUntil, 1U);
        EXPECT_EQ(layout.places[2].usesBefore, 3U);
    }
}

TEST(Heap, OfEqualResourcesIsItsPeak) {
    std::vector<MemoryClaim> claims = randomClaims(7, 500, 40);
    for (MemoryClaim& claim : claims) {
        claim.bytes = claim.alignment = 4096;
        claim.waitedFor = claim.first;
    }
    for (const Policy policy : policies) EXPECT_EQ(placeInHeap(claims, policy).bytes, peakOf(claims));
}

/// The memory of claim 0 would fit as well, but whoever takes it must wait for pass 3.
TEST(Heap, PrefersMemoryThatCostsNoBatchOfBarriers) {
    const std::vector<MemoryClaim> claims{
        {256, 256, 0, 3, 1}, {4096, 256, 0, 1, 1}, {4096, 256, 0, 5, 1}, {256, 256, 4, 5, 1, 2}};
    const HeapLayout layout = placeInHeap(claims, Policy::Barriers);
    EXPECT_EQ(layout.places[3].usedUntil, 1U);
    EXPECT_EQ(layout.bytes, 4096U + 4096 + 256);
}

/// Eight small resources die one after the other while eight come to life, one each pass of one level: the
/// first that must take memory of that level waits for all that is dead by then.
TEST(Heap, OneBatchServesAllThatIsDeadByThen) {
    std::vector<MemoryClaim> claims;
    for (Index i = 0; i < 8; ++i) claims.push_back({256, 256, 0, 1 + i / 4, 1});
    claims.push_back({2560, 256, 0, 9, 1});
    for (Index i = 0; i < 4; ++i) claims.push_back({256, 256, 3 + i, 9, 1, 1});
    const HeapLayout layout = placeInHeap(claims, Policy::Barriers);
    EXPECT_EQ(layout.bytes, 8U * 256 + 2560);
    for (std::size_t i = 9; i < claims.size(); ++i) EXPECT_LT(layout.places[i].usedUntil, 3U);
}

TEST(Heap, NeverPutsTwoLivingResourcesOverEachOther) {
    for (Index seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        const auto claims = randomClaims(seed, 1 + seed % 90, seed % 2 == 0 ? 8 : 60);
        for (const Policy policy : policies) {
            const HeapLayout layout = placeInHeap(claims, policy);
            expectSound(claims, layout);
            expectPast(claims, layout);
        }
    }
}

/// More gaps at once than the table of gaps holds: they must not be forgotten.
TEST(Heap, UsesManyGapsOfOneSizeAgain) {
    constexpr Index count = 1000;
    std::vector<MemoryClaim> claims;
    for (Index i = 0; i < count; ++i) claims.push_back({256, 256, 0, i % 2 == 0 ? 0U : 2U, 1});
    for (Index i = 0; i < count / 2; ++i) claims.push_back({256, 256, 1, 2, 1, 1});
    for (const Policy policy : policies) EXPECT_EQ(placeInHeap(claims, policy).bytes, 256U * count);
}

TEST(Heap, AHundredThousandResourcesAliveAtOnce) {
    constexpr Index count = 100000;
    std::vector<MemoryClaim> claims = randomClaims(1, count, count);
    for (Index i = 0; i < count / 2; ++i) claims[i] = {256, 256, 0, 2 * i + 1, 1};
    const HeapLayout layout = placeInHeap(claims, Policy::Barriers);
    std::uint64_t sum = 0;
    for (const MemoryClaim& claim : claims) sum += claim.bytes + claim.alignment;
    EXPECT_LE(layout.bytes, sum);
    EXPECT_GE(layout.bytes, 256U * (count / 2));
}

}  // namespace
}  // namespace nephrite::graph::tests
