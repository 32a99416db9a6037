// Random graphs against the independent oracle and against the rules of skipping and culling; and the oracle
// against plans with one thing broken on purpose.
#include "graph/plan_oracle.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "graph/compile.h"
#include "graph/random_graphs.h"

namespace nephrite::graph::tests {
namespace {

using testing::IsEmpty;
using testing::Not;

/// The plan with the barriers of batch `batch` (passes().size() for the last one) replaced.
Plan withBatch(const Plan& plan, Index batch, const std::vector<Barrier>& replacement) {
    Plan result = plan;
    result.barriers.clear();
    for (Index i = 0; i <= plan.passes.size(); ++i) {
        Range& range = i < plan.passes.size() ? result.passes[i].barriers : result.finalBarriers;
        const auto before = slice(plan.barriers, range);
        const std::vector<Barrier> barriers =
            i == batch ? replacement : std::vector<Barrier>(before.begin(), before.end());
        range = {static_cast<Index>(result.barriers.size()), static_cast<Index>(barriers.size())};
        result.barriers.insert(result.barriers.end(), barriers.begin(), barriers.end());
    }
    return result;
}

/// Calls `check` with the plan changed at each single barrier: `change` edits the barrier's batch at that
/// position.
template<class Change, class Check>
void forEachBarrier(const Plan& plan, Change change, Check check) {
    for (Index batch = 0; batch <= plan.passes.size(); ++batch) {
        const Range range = batch < plan.passes.size() ? plan.passes[batch].barriers : plan.finalBarriers;
        const auto barriers = slice(plan.barriers, range);
        for (std::size_t i = 0; i < barriers.size(); ++i) {
            std::vector<Barrier> changed(barriers.begin(), barriers.end());
            change(changed, i);
            check(withBatch(plan, batch, changed), barriers[i]);
        }
    }
}

std::string describe(const Plan& plan, const Barrier& barrier) {
    return fmt::format("{} {} -> {}", plan.nameOf(plan.resources[barrier.resource]), name(barrier.oldLayout),
                       name(barrier.newLayout));
}

TEST(PlanOracle, FindsNothingInThreeThousandRandomPlans) {
    std::size_t passes = 0;
    std::size_t barriers = 0;
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        const Plan plan = compile(randomRequest(seed, 40));
        passes += plan.passes.size();
        barriers += plan.barriers.size();
        ASSERT_THAT(findHazards(plan), IsEmpty()) << "seed " << seed;
    }
    // The graphs are not trivial: several passes and barriers each.
    EXPECT_GT(passes, 3000U * 4);
    EXPECT_GT(barriers, 3000U * 8);
}

TEST(PlanOracle, FindsNothingInPlansOfAFreshSeed) {
    const std::uint64_t seed = std::random_device{}();
    fmt::print("fresh seed {}\n", seed);
    for (std::uint64_t i = 0; i < 500; ++i) {
        ASSERT_THAT(findHazards(compile(randomRequest(seed + i, 60))), IsEmpty()) << "seed " << seed + i;
    }
}

TEST(PlanOracle, CatchesTheRemovalOfAnyOneBarrier) {
    std::size_t removed = 0;
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
        const Plan plan = compile(randomRequest(seed, 20));
        forEachBarrier(
            plan,
            [](std::vector<Barrier>& batch, std::size_t i) {
                batch.erase(batch.begin() + static_cast<std::ptrdiff_t>(i));
            },
            [&](const Plan& broken, const Barrier& barrier) {
                ++removed;
                EXPECT_THAT(findHazards(broken), Not(IsEmpty()))
                    << "seed " << seed << ", " << describe(plan, barrier);
            });
    }
    EXPECT_GT(removed, 1000U);
}

TEST(PlanOracle, FindsADuplicatedBarrierNeedless) {
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
        const Plan plan = compile(randomRequest(seed, 20));
        forEachBarrier(
            plan, [](std::vector<Barrier>& batch, std::size_t i) { batch.push_back(batch[i]); },
            [&](const Plan& broken, const Barrier& barrier) {
                EXPECT_THAT(findHazards(broken), Not(IsEmpty()))
                    << "seed " << seed << ", " << describe(plan, barrier);
            });
    }
}

TEST(PlanOracle, CatchesEachPartOfABarrierThatIsWrong) {
    const auto expectCaught = [](const char* what, auto edit) {
        for (std::uint64_t seed = 0; seed < 60; ++seed) {
            const Plan plan = compile(randomRequest(seed, 20));
            forEachBarrier(
                plan, [&](std::vector<Barrier>& batch, std::size_t i) { edit(batch[i]); },
                [&](const Plan& broken, const Barrier& barrier) {
                    EXPECT_THAT(findHazards(broken), Not(IsEmpty()))
                        << what << ", seed " << seed << ", " << describe(plan, barrier);
                });
        }
    };
    expectCaught("nothing waits", [](Barrier& barrier) { barrier.usesAfter = 0; });
    expectCaught("one waiting use forgotten",
                 [](Barrier& barrier) { barrier.usesAfter &= barrier.usesAfter - 1; });
    expectCaught("one use too many waits", [](Barrier& barrier) {
        barrier.usesAfter |= barrier.usesAfter & bit(Use::Clear) ? bit(Use::ComputeRead) : bit(Use::Clear);
    });
    expectCaught("another layout", [](Barrier& barrier) {
        barrier.newLayout = barrier.newLayout == Layout::General ? Layout::ShaderRead : Layout::General;
    });
    expectCaught("waits for a use that was not", [](Barrier& barrier) {
        barrier.usesBefore |= barrier.usesBefore & bit(Use::Copy) ? bit(Use::Clear) : bit(Use::Copy);
    });
    expectCaught("availability the other way",
                 [](Barrier& barrier) { barrier.writeBefore = !barrier.writeBefore; });
    expectCaught("half the image", [](Barrier& barrier) { barrier.baseLayer = 1; });
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
        for (std::uint32_t i = 0; i < 16; ++i) {
            request.facts.translucentMaterials = i % 2;
            request.facts.maxLayers = i % 2 * 3;
            request.facts.lightViews = i / 2 % 2 * 6;
            request.inputReads = i / 4 % 2 == 0 ? InputReads::StorageImage : InputReads::SampledImage;
            request.skip = i / 8 == 0;
            EXPECT_THAT(findHazards(compile(request)), IsEmpty()) << entry.path() << ", " << i;
        }
    }
    EXPECT_GT(graphs, 0U);
}

/// What skipping and culling must keep to, checked without following the compiler's own steps.
class DecisionCheck {
  public:
    DecisionCheck(const CompileRequest& request, const Plan& plan)
        : request_(request), plan_(plan), passOf_(plan.nodes.size(), noIndex) {
        for (Index i = 0; i < plan.passes.size(); ++i) passOf_[plan.passes[i].node] = i;
    }

    void check() const {
        for (Index node = 0; node < plan_.nodes.size(); ++node) {
            switch (plan_.nodes[node].state) {
                case NodeState::Run:
                    EXPECT_NE(passOf_[node], noIndex);
                    EXPECT_TRUE(isDemanded(node)) << "n" << node << " runs for nothing";
                    EXPECT_FALSE(isOff(node));
                    break;
                case NodeState::Skipped:
                    EXPECT_EQ(passOf_[node] != noIndex, isRequested(node));
                    EXPECT_FALSE(isRead(node));
                    EXPECT_TRUE(request_.skip || isOffByWhen(node)) << "n" << node;
                    break;
                case NodeState::Culled:
                    EXPECT_EQ(passOf_[node], noIndex);
                    EXPECT_FALSE(isRequested(node) || plan_.graph->nodes[node].type->sideEffect);
                    EXPECT_FALSE(isRead(node));
                    break;
            }
        }
        checkReads();
    }

  private:
    bool isOffByWhen(Index node) const {
        const auto& when = plan_.graph->description.nodes[node].when;
        return when && when->program()[0].constant == 0;
    }
    bool isOff(Index node) const {
        const auto& skipWhen = plan_.graph->nodes[node].type->skipWhen;
        const bool isConstant = skipWhen && skipWhen->names().empty();
        return isOffByWhen(node) || (request_.skip && isConstant && skipWhen->program()[0].constant != 0);
    }
    bool isRequested(Index node) const {
        for (const LinkedOutput& output : plan_.graph->outputs) {
            if (output.node == node) return true;
        }
        return false;
    }
    bool isRead(Index node) const {
        for (const InputRead& read : plan_.inputs) {
            if (read.resource != noIndex && plan_.resources[read.resource].node == node) return true;
        }
        return false;
    }
    /// An empty buffer is read without a resource, so readers are found through the graph.
    bool isDemanded(Index node) const {
        if (isRequested(node) || plan_.graph->nodes[node].type->sideEffect) return true;
        for (const PlannedPass& pass : plan_.passes) {
            if (pass.iterations == 0) continue;
            const LinkedNode& reader = plan_.graph->nodes[pass.node];
            for (Index i = 0; i < reader.inputs.count; ++i) {
                if (plan_.graph->inputs[reader.inputs.first + i].sourceNode == node &&
                    isNeeded(*reader.type, i))
                    return true;
            }
        }
        return false;
    }
    bool isNeeded(const PassType& type, Index input) const {
        const auto& neededWhen = type.inputs[input].neededWhen;
        return !request_.skip || !neededWhen || neededWhen->program()[0].constant != 0;
    }

    /// A running pass reads exactly the inputs that are needed and whose source runs.
    void checkReads() const {
        for (const PlannedPass& pass : plan_.passes) {
            const LinkedNode& node = plan_.graph->nodes[pass.node];
            for (Index i = 0; i < node.inputs.count; ++i) {
                const LinkedInput& source = plan_.graph->inputs[node.inputs.first + i];
                const Index resource = plan_.inputs[pass.inputs.first + i].resource;
                const bool mayRead = pass.iterations > 0 && source.sourceNode != noIndex &&
                                     isNeeded(*node.type, i) &&
                                     plan_.nodes[source.sourceNode].state == NodeState::Run;
                if (!mayRead) {
                    EXPECT_EQ(resource, noIndex);
                } else if (resource != noIndex) {
                    EXPECT_EQ(plan_.resources[resource].node, source.sourceNode);
                    EXPECT_EQ(plan_.resources[resource].port, source.sourcePort);
                } else {
                    EXPECT_FALSE(plan_.graph->nodes[source.sourceNode]
                                     .type->outputs[source.sourcePort]
                                     .bufferElement.empty());
                }
            }
        }
    }

    const CompileRequest& request_;
    const Plan& plan_;
    std::vector<Index> passOf_;
};

TEST(RandomPlans, KeepToTheRulesOfSkippingAndCulling) {
    std::array<std::size_t, 3> states{};
    for (std::uint64_t seed = 5000; seed < 6500; ++seed) {
        const CompileRequest request = randomRequest(seed, 25);
        const Plan plan = compile(request);
        DecisionCheck(request, plan).check();
        ASSERT_FALSE(HasFailure()) << "seed " << seed;
        for (const NodeDecision& node : plan.nodes) ++states[static_cast<std::size_t>(node.state)];
    }
    for (const std::size_t count : states) EXPECT_GT(count, 1000U);
}

TEST(RandomPlans, EveryNodeHasAReasonInWords) {
    for (std::uint64_t seed = 7000; seed < 7300; ++seed) {
        const Plan plan = compile(randomRequest(seed, 25));
        for (Index node = 0; node < plan.nodes.size(); ++node) EXPECT_GT(whyOf(plan, node).size(), 10U);
    }
}

TEST(RandomPlans, TheSameRequestGivesTheSamePlan) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const Plan first = compile(randomRequest(seed, 40));
        const Plan second = compile(randomRequest(seed, 40));
        ASSERT_EQ(first.passes.size(), second.passes.size());
        for (std::size_t i = 0; i < first.passes.size(); ++i)
            EXPECT_EQ(first.passes[i].node, second.passes[i].node);
        EXPECT_EQ(first.barriers.size(), second.barriers.size());
    }
}

}  // namespace
}  // namespace nephrite::graph::tests
