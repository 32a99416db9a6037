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

/// What a run may lack by chance: only passes over the lights of a scene without any clear and do no more.
constexpr std::string_view rare = "passes that only clear";

/// What a session holds depends on its graph and its pipelines; what is held while there is none is
/// comparable.
test::MemoryGrowth soak(Validation validation) {
    const std::uint64_t seed = std::random_device{}();
    fmt::print("seed {}\n", seed);
    test::RandomChanges changes(seed, validation);
    test::MemoryGrowth memory;
    for (int frame = 1; frame <= frames; ++frame) {
        EXPECT_NO_THROW(changes.frame()) << "frame " << frame << ", seed " << seed << "\n" << changes.story();
        if (testing::Test::HasFailure()) return memory;
        if (frame % sessionFrames != 0) continue;
        changes.endSession();
        memory.add(test::sampleMemory());
    }
    for (const auto& [what, count] : changes.counts()) {
        fmt::print("{}: {}\n", what, count);
        EXPECT_TRUE(count > 0 || what == rare) << what;
    }
    fmt::print("{}", memory.table());
    return memory;
}

TEST(Soak, TenThousandFramesOfRandomChangesAreValid) {
    soak(Validation::Sync);
}

// The validation layer itself holds 10 KB more after each plan that is made, whatever it validates.
TEST(Soak, TenThousandFramesOfRandomChangesLeaveNothingBehind) {
    const test::MemoryGrowth memory = soak(Validation::Off);
    ASSERT_FALSE(HasFailure());
    EXPECT_LT(memory.share().resident, flat);
    EXPECT_LT(memory.share().heap, flat);
}

}  // namespace
}  // namespace nephrite::runtime
