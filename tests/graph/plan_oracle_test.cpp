// Random graphs, and the project's own, against the independent oracle.
#include "graph/plan_oracle.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "graph/compile.h"
#include "graph/plan_writer.h"
#include "graph/random_graphs.h"

namespace nephrite::graph::tests {
namespace {

using testing::IsEmpty;

/// Mostly small graphs, now and then one of up to 200 nodes.
Index mostNodes(std::uint64_t seed) {
    return seed % 64 == 0 ? 200 : 40;
}

std::string inWords(const std::vector<std::string>& findings, const Plan& plan, std::uint64_t seed) {
    return fmt::format("seed {}:\n  {}\n{}", seed, fmt::join(findings, "\n  "),
                       plan.passes.size() <= 20 ? planAsText(plan) : std::string());
}

/// What the graphs of a run were made of, so that a generator gone dull does not pass for a proof.
struct Tally {
    std::size_t passes = 0, barriers = 0, aliases = 0, levels = 0, kept = 0, history = 0, imports = 0,
                buffers = 0;
    std::size_t modified = 0, overMips = 0, cleared = 0, tiled = 0, partial = 0;

    void add(const Plan& plan) {
        passes += plan.passes.size();
        barriers += plan.schedule.barriers.size();
        for (const Barrier& barrier : plan.schedule.barriers) {
            aliases += barrier.aliases ? 1 : 0;
            levels += barrier.range == plan.resources[barrier.resource].whole() ? 0 : 1;
        }
        for (const Resource& resource : plan.resources) {
            kept += resource.kind == ResourceKind::Kept ? 1 : 0;
            history += resource.framesBack > 0 ? 1 : 0;
            imports += resource.kind == ResourceKind::Imported ? 1 : 0;
            buffers += resource.isBuffer ? 1 : 0;
        }
        for (const InputRead& input : plan.inputs) modified += input.modified ? 1 : 0;
        for (const PlannedPass& pass : plan.passes) {
            overMips += pass.forEach == ForEach::Mips ? 1 : 0;
            cleared += pass.iterations == 0 ? 1 : 0;
            tiled += pass.tileList != noIndex ? 1 : 0;
        }
    }
};

/// One random graph: the whole frame, and for one in four also a frame that leaves passes out.
void check(std::uint64_t seed, Tally& tally) {
    const CompileRequest request = randomRequest(seed, mostNodes(seed));
    const Plan plan = compile(request);
    tally.add(plan);
    const std::vector<std::string> faults = findFaults(request, plan);
    ASSERT_TRUE(faults.empty()) << inWords(faults, plan, seed);
    if (seed % 4 != 0) return;
    const std::vector<std::uint8_t> runs = randomRuns(plan, seed);
    tally.partial += std::count(runs.begin(), runs.end(), 0) > 0 ? 1 : 0;
    const std::vector<std::string> hazards = findHazards(plan, runs, scheduleBarriers(plan, runs));
    ASSERT_TRUE(hazards.empty()) << inWords(hazards, plan, seed)
                                 << fmt::format("of {}", fmt::join(runs, " "));
}

/// Five thousand seeds from `first`; the four tests that call it make 20,000 graphs.
void checkFiveThousand(std::uint64_t first) {
    Tally tally;
    for (std::uint64_t seed = first; seed < first + 5000; ++seed) {
        check(seed, tally);
        ASSERT_FALSE(testing::Test::HasFatalFailure());
    }
    EXPECT_GT(tally.passes, 5000U * 6);
    EXPECT_GT(tally.barriers, 5000U * 12);
    for (const auto& [what, count] : {std::pair("aliases", tally.aliases),
                                      {"levels", tally.levels},
                                      {"kept", tally.kept},
                                      {"history", tally.history},
                                      {"imports", tally.imports},
                                      {"buffers", tally.buffers},
                                      {"modified", tally.modified},
                                      {"over mips", tally.overMips},
                                      {"cleared", tally.cleared},
                                      {"tiled", tally.tiled},
                                      {"partial", tally.partial}}) {
        EXPECT_GT(count, 500U) << what;
    }
}

TEST(PlanOracle, FindsNothingInTheFirstFiveThousandGraphs) {
    checkFiveThousand(0);
}
TEST(PlanOracle, FindsNothingInTheSecondFiveThousandGraphs) {
    checkFiveThousand(5000);
}
TEST(PlanOracle, FindsNothingInTheThirdFiveThousandGraphs) {
    checkFiveThousand(10000);
}
TEST(PlanOracle, FindsNothingInTheFourthFiveThousandGraphs) {
    checkFiveThousand(15000);
}

TEST(PlanOracle, FindsNothingInGraphsOfAFreshSeed) {
    const std::uint64_t fresh = std::random_device{}();
    fmt::print("fresh seed {}\n", fresh);
    RecordProperty("seed", std::to_string(fresh));
    Tally tally;
    for (std::uint64_t seed = fresh; seed < fresh + 1000; ++seed) {
        check(seed, tally);
        ASSERT_FALSE(HasFatalFailure());
    }
}

TEST(PlanOracle, FindsNothingInTheProjectsOwnGraphs) {
    const std::filesystem::path root = NEPHRITE_SOURCE_DIR;
    const PassLibrary library({root / "passes"}, root / "shaders");
    std::size_t graphs = 0;
    for (const auto& entry : std::filesystem::directory_iterator(root / "graphs")) {
        if (entry.path().extension() != ".json") continue;
        ++graphs;
        CompileRequest request;
        request.graph = link(readGraph(entry.path()), library);
        request.view = {512, 512};
        for (std::uint32_t i = 0; i < 96; ++i) {
            request.facts.translucentMaterials = i % 2;
            request.facts.maxLayers = i % 2 * 3;
            request.facts.lightViews = i / 2 % 2 * 6;
            request.inputReads = i / 4 % 2 == 0 ? InputReads::StorageImage : InputReads::SampledImage;
            request.skip = i / 8 % 2 == 0;
            request.policy = i / 16 % 2 == 0 ? Policy::Barriers : Policy::Memory;
            request.keep = static_cast<Keep>(i / 32);
            EXPECT_THAT(findFaults(request, compile(request)), IsEmpty()) << entry.path() << ", " << i;
        }
    }
    EXPECT_GT(graphs, 0U);
}

TEST(RandomPlans, EveryNodeHasAReasonInWords) {
    for (std::uint64_t seed = 7000; seed < 7300; ++seed) {
        const Plan plan = compile(randomRequest(seed, 25));
        for (Index node = 0; node < plan.nodes.size(); ++node) EXPECT_GT(whyOf(plan, node).size(), 10U);
    }
}

TEST(RandomPlans, TheSameRequestGivesTheSamePlan) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        EXPECT_EQ(planAsText(compile(randomRequest(seed, 40))), planAsText(compile(randomRequest(seed, 40))));
    }
}

}  // namespace
}  // namespace nephrite::graph::tests
