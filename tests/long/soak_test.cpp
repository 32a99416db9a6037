// Ten thousand frames in which parameters, sizes, cameras, times and graphs change at random: validation says
// nothing, and nothing grows.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "memory_growth.h"
#include "random_changes.h"

namespace nephrite::runtime {
namespace {

constexpr int frames = 10000;
constexpr int sessionFrames = 250;

/// What the memory of a process may grow by from the first frames to the last, as a share.
constexpr double flat = 0.05;

TEST(Soak, TenThousandFramesOfRandomChangesLeaveNothingBehind) {
    const std::uint64_t seed = std::random_device{}();
    fmt::print("seed {}\n", seed);
    test::RandomChanges changes(seed);
    test::MemoryGrowth memory;
    for (int frame = 0; frame < frames; ++frame) {
        ASSERT_NO_THROW(changes.frame()) << "frame " << frame << ", seed " << seed << "\n" << changes.story();
        if ((frame + 1) % sessionFrames != 0) continue;
        // A session holds what its graph and its pipelines take; what is held when there is none is
        // comparable.
        changes.endSession();
        memory.add(test::sampleMemory());
    }
    for (const auto& [what, count] : changes.counts()) {
        fmt::print("{}: {}\n", what, count);
        EXPECT_GT(count, 0U) << what;
    }
    fmt::print("{}", memory.table());
    EXPECT_LT(memory.share().resident, flat);
    EXPECT_LT(memory.share().heap, flat);
}

}  // namespace
}  // namespace nephrite::runtime
