// What enters and leaves a frame: history, images from outside, and images that are copied out. The oracle
// agrees with each of these plans.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "graph/sound_plans.h"

namespace nephrite::graph::tests {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr auto* feedback = R"json({"nodes": {"a": {"pass": "source"},
    "t": {"pass": "blend", "in": {"a": "a.color", "b": "previous(t.color)"}}},
    "outputs": {"color": "t.color"}})json";

TEST(Outside, HistoryIsReadBeforeItIsWrittenAndRestsInOneLayout) {
    const Plan plan = soundPlanOf(feedback, sampled());
    const Resource& now = resourceNamed(plan, "t.color");
    const Resource& before = resourceNamed(plan, "previous(t.color)");
    EXPECT_EQ(now.kind, ResourceKind::History);
    EXPECT_EQ(before.kind, ResourceKind::History);
    EXPECT_EQ(before.framesBack, 1U);
    EXPECT_NE(before.initial, Layout::Undefined);
    for (const Resource* resource : {&now, &before}) {
        EXPECT_EQ(resource->initial, before.initial);
        EXPECT_EQ(resource->final, before.initial);
        EXPECT_EQ(resource->offset, Resource::noOffset);
    }
}

TEST(Outside, HistoryAcrossCullingKeepsItsSourceAlive) {
    const auto* graph = R"json({"parameters": {"on": {"value": @}}, "nodes": {"a": {"pass": "source"},
        "t": {"pass": "blend", "in": {"a": "b.color", "b": "previous(a.color, 2)"}},
        "b": {"pass": "source"},
        "end": {"pass": "blend", "in": {"a": "b.color", "b": "t.color"}, "set": {"useB": "$on"}}},
        "outputs": {"color": "end.color"}})json";
    const auto with = [&](const std::string& value) {
        std::string text = graph;
        return text.replace(text.find('@'), 1, value);
    };
    const Plan on = soundPlanOf(with("true"));
    EXPECT_EQ(stateOf(on, "a"), NodeState::Run) << "no pass reads this frame's, a later frame does";
    EXPECT_EQ(resourceNamed(on, "a.color").kind, ResourceKind::History);
    EXPECT_EQ(on.resources[inputOf(on, "t", "b").resource].framesBack, 2U);
    const Plan off = soundPlanOf(with("false"));
    EXPECT_EQ(stateOf(off, "t"), NodeState::Skipped);
    EXPECT_EQ(stateOf(off, "a"), NodeState::Culled) << "nobody reads its history any more";
}

TEST(Outside, HistoryAcrossAReloadGoesByTheSameNamesAndRestsAsBefore) {
    const Plan before = soundPlanOf(feedback);
    const Plan after = soundPlanOf(
        R"json({"nodes": {"new": {"pass": "source"}, "a": {"pass": "filter", "in": {"a": "new.color"}},
        "t": {"pass": "blend", "in": {"a": "a.color", "b": "previous(t.color)"}}},
    "outputs": {"color": "t.color"}})json");
    for (const auto* name : {"t.color", "previous(t.color)"}) {
        EXPECT_EQ(resourceNamed(before, name).extent, resourceNamed(after, name).extent);
        EXPECT_EQ(resourceNamed(before, name).format, resourceNamed(after, name).format);
        EXPECT_EQ(resourceNamed(before, name).initial, resourceNamed(after, name).initial);
    }
}

/// An image from outside that one pass reads.
constexpr auto* reader =
    R"json({"imports": {"table": {}}, "nodes": {"f": {"pass": "filter", "in": {"a": "import(table)"}}},
    "outputs": {"color": "f.color"}})json";

TEST(Outside, AnImportedImageInTheWrongStateIsChangedOnce) {
    const Plan plan = soundPlanOf(
        reader, withImport({.initial = Layout::ColorAttachment, .usesBefore = bit(Use::ColorAttachment)}));
    const auto barriers = barriersOver(plan, "import(table)", {0, 1, 0, 1});
    ASSERT_THAT(barriers, SizeIs(1));
    EXPECT_EQ(barriers[0].oldLayout, Layout::ColorAttachment);
    EXPECT_EQ(barriers[0].newLayout, Layout::General);
    EXPECT_THAT(barriers[0], waits(Use::ColorAttachment, Use::ComputeRead));
    EXPECT_TRUE(barriers[0].writeBefore);
}

TEST(Outside, AnImportedImageInTheRightStateIsLeftAlone) {
    const Plan plan = soundPlanOf(reader, withImport({.initial = Layout::General}));
    EXPECT_THAT(barriersOver(plan, "import(table)", {0, 1, 0, 1}), IsEmpty());
}

TEST(Outside, AnImportedImageIsHandedBackInTheStateItsOwnerWants) {
    const Plan plan =
        soundPlanOf(reader, withImport({.initial = Layout::General, .final = Layout::ColorAttachment}));
    const auto barriers = barriersOver(plan, "import(table)", {0, 1, 0, 1});
    ASSERT_THAT(barriers, SizeIs(1));
    EXPECT_EQ(barriers[0].usesBefore, bit(Use::ComputeRead));
    EXPECT_EQ(barriers[0].newLayout, Layout::ColorAttachment);
}

TEST(Outside, ExportedImagesEndInTheStateTheyAreCopiedFrom) {
    const Plan plan =
        soundPlanOf(R"json({"nodes": {"a": {"pass": "source"}, "b": {"pass": "draw", "in": {"a": "a.color"}}},
        "outputs": {"a": "a.color", "b": "b.color", "depth": "b.depth"}})json");
    EXPECT_THAT(barriersAtEnd(plan), SizeIs(3));
    for (const auto* name : {"a.color", "b.color", "b.depth"}) {
        const auto barriers = barriersOver(plan, name, {0, 1, 0, 1});
        EXPECT_EQ(barriers.back().newLayout, Layout::TransferSource) << name;
        EXPECT_EQ(barriers.back().usesAfter, bit(Use::Copy)) << name;
        EXPECT_EQ(resourceNamed(plan, name).last, 1U) << "until the copies, past the last pass";
    }
}

}  // namespace
}  // namespace nephrite::graph::tests
