// Plans broken on purpose, as a faulty compiler would break them: the oracle must catch every one. Each test
// states by its loop which changes it makes; all of them matter, because the unbroken plan has nothing to
// spare.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <utility>

#include "graph/compile.h"
#include "graph/plan_oracle.h"
#include "graph/random_graphs.h"

namespace nephrite::graph::tests {
namespace {

/// How many plans were broken, and in how many of them the oracle found something.
struct Score {
    std::size_t broken = 0;
    std::size_t caught = 0;
    std::string missed;  ///< the first that was not caught

    void add(const std::vector<std::string>& findings, std::uint64_t seed, const std::string& what) {
        ++broken;
        caught += findings.empty() ? 0 : 1;
        if (findings.empty() && missed.empty()) missed = fmt::format("seed {}: {}", seed, what);
    }
    void expectAllCaught(std::size_t least) const {
        EXPECT_EQ(caught, broken) << missed;
        EXPECT_GT(broken, least);
    }
};

/// Calls `check` with the seed, request and plan of `count` random graphs.
template<class Check>
void forEachPlan(std::uint64_t count, Check check) {
    for (std::uint64_t seed = 30000; seed < 30000 + count; ++seed) {
        const CompileRequest request = randomRequest(seed, 25);
        check(seed, request, compile(request));
    }
}

std::string describe(const Plan& plan, const Barrier& barrier) {
    return fmt::format("{} {} -> {}", plan.nameOf(plan.resources[barrier.resource]), name(barrier.oldLayout),
                       name(barrier.newLayout));
}

void recountBatches(BarrierSchedule& schedule) {
    schedule.batchCount = 0;
    for (const Range& batch : schedule.batches) schedule.batchCount += batch.count > 0 ? 1 : 0;
}

/// Inserts (+1) a copy of a barrier beside it, or removes (-1) it.
void changeCount(BarrierSchedule& schedule, Index index, int change) {
    const auto position = schedule.barriers.begin() + index;
    const Barrier copy = *position;
    if (change > 0) {
        schedule.barriers.insert(position, copy);
    } else {
        schedule.barriers.erase(position);
    }
    bool isBehind = false;
    for (Range& batch : schedule.batches) {
        if (isBehind) batch.first += static_cast<Index>(change);
        if (batch.first <= index && index < batch.first + batch.count && !isBehind) {
            batch.count += static_cast<Index>(change);
            isBehind = true;
        }
    }
    recountBatches(schedule);
}

TEST(Sabotage, DroppingAnyOneBarrierIsCaught) {
    Score score;
    forEachPlan(150, [&](std::uint64_t seed, const CompileRequest&, const Plan& plan) {
        for (Index i = 0; i < plan.schedule.barriers.size(); ++i) {
            Plan broken = plan;
            changeCount(broken.schedule, i, -1);
            score.add(findHazards(broken), seed, describe(plan, plan.schedule.barriers[i]));
        }
    });
    score.expectAllCaught(2000);
}

TEST(Sabotage, ALifetimeOnePassShorterIsCaught) {
    Score score;
    forEachPlan(300, [&](std::uint64_t seed, const CompileRequest&, const Plan& plan) {
        for (std::size_t i = 0; i < plan.resources.size(); ++i) {
            const Resource& resource = plan.resources[i];
            if (resource.first >= resource.last || resource.last == noIndex) continue;
            Plan broken = plan;
            ++broken.resources[i].first;
            score.add(findHazards(broken), seed, plan.nameOf(resource) + " starts later");
            broken.resources[i] = resource;
            --broken.resources[i].last;
            score.add(findHazards(broken), seed, plan.nameOf(resource) + " ends earlier");
        }
    });
    score.expectAllCaught(2000);
}

/// Whether `user` reads what `writer` writes.
bool readsFrom(const Plan& plan, const PlannedPass& user, const PlannedPass& writer) {
    for (const InputRead& input : slice(plan.inputs, user.inputs)) {
        if (input.resource == noIndex) continue;
        for (const Index output : slice(plan.outputs, writer.outputs)) {
            if (output == input.resource) return true;
        }
    }
    return false;
}

TEST(Sabotage, TwoAllocationsThatAreAliveAtOnceInTheSameBytesAreCaught) {
    Score score;
    forEachPlan(200, [&](std::uint64_t seed, const CompileRequest&, const Plan& plan) {
        for (std::size_t i = 0; i < plan.resources.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const Resource& a = plan.resources[i];
                const Resource& b = plan.resources[j];
                const bool inHeap = a.offset != Resource::noOffset && b.offset != Resource::noOffset;
                if (!inHeap || a.first > b.last || b.first > a.last) continue;
                Plan broken = plan;
                broken.resources[i].offset = b.offset;
                broken.heapBytes = std::max(broken.heapBytes, b.offset + a.bytes);
                score.add(findHazards(broken), seed, plan.nameOf(a) + " over " + plan.nameOf(b));
            }
        }
    });
    score.expectAllCaught(2000);
}

TEST(Sabotage, TwoDependentPassesInTheOtherOrderAreCaught) {
    Score score;
    forEachPlan(300, [&](std::uint64_t seed, const CompileRequest& request, const Plan& plan) {
        for (std::size_t user = 0; user < plan.passes.size(); ++user) {
            for (std::size_t writer = 0; writer < user; ++writer) {
                const PlannedPass& first = plan.passes[writer];
                const PlannedPass& second = plan.passes[user];
                // Others would not fit between the batches that are there.
                if (first.batchCount() != second.batchCount() || !readsFrom(plan, second, first)) continue;
                Plan broken = plan;
                std::swap(broken.passes[writer], broken.passes[user]);
                std::swap(broken.passes[writer].firstBatch, broken.passes[user].firstBatch);
                score.add(findFaults(request, broken), seed,
                          plan.nameOf(first) + " and " + plan.nameOf(second));
            }
        }
    });
    score.expectAllCaught(1000);
}

/// The request with a node made one of side effects, and the pass type that says so.
struct Revived {
    PassType type;
    LinkedGraph graph;
};
CompileRequest withSideEffect(const CompileRequest& request, Index node) {
    const auto revived = std::make_shared<Revived>(Revived{*request.graph->nodes[node].type, *request.graph});
    revived->type.sideEffect = true;
    revived->graph.nodes[node].type = &revived->type;
    indexGraph(revived->graph);
    CompileRequest result = request;
    result.graph = {revived, &revived->graph};
    return result;
}

TEST(Sabotage, ADeadPassThatIsKeptIsCaught) {
    Score score;
    forEachPlan(150, [&](std::uint64_t seed, const CompileRequest& request, const Plan& plan) {
        for (Index node = 0; node < plan.nodes.size(); ++node) {
            const bool isPass = plan.graph->nodes[node].role == NodeRole::Pass;
            if (!isPass || plan.nodes[node].state != NodeState::Culled) continue;
            // What a compiler would make that takes the node for needed. A node that is switched off stays
            // so.
            Plan broken = compile(withSideEffect(request, node));
            if (broken.nodes[node].state != NodeState::Run) continue;
            broken.graph = plan.graph;
            score.add(findFaults(request, broken), seed, plan.graph->nodeName(node));
        }
    });
    score.expectAllCaught(500);
}

TEST(Sabotage, ADuplicatedBarrierIsFoundNeedless) {
    Score score;
    forEachPlan(100, [&](std::uint64_t seed, const CompileRequest&, const Plan& plan) {
        for (Index i = 0; i < plan.schedule.barriers.size(); ++i) {
            Plan broken = plan;
            changeCount(broken.schedule, i, 1);
            score.add(findHazards(broken), seed, describe(plan, plan.schedule.barriers[i]));
        }
    });
    score.expectAllCaught(1000);
}

/// Changes each barrier alone by `edit`, which says whether that was a change.
template<class Edit>
void expectEachCaught(const char* what, Edit edit) {
    Score score;
    forEachPlan(300, [&](std::uint64_t seed, const CompileRequest&, const Plan& plan) {
        Plan broken = plan;
        for (std::size_t i = 0; i < plan.schedule.barriers.size(); ++i) {
            Barrier& barrier = broken.schedule.barriers[i];
            if (edit(barrier)) score.add(findHazards(broken), seed, describe(plan, barrier));
            barrier = plan.schedule.barriers[i];
        }
    });
    SCOPED_TRACE(what);
    score.expectAllCaught(100);
}

TEST(Sabotage, EachPartOfABarrierThatIsWrongIsCaught) {
    expectEachCaught("one waiting use forgotten", [](Barrier& barrier) {
        barrier.usesAfter &= barrier.usesAfter - 1;
        return barrier.usesAfter != 0;
    });
    expectEachCaught("one use too many waits", [](Barrier& barrier) {
        barrier.usesAfter |= barrier.usesAfter & bit(Use::Clear) ? bit(Use::RasterRead) : bit(Use::Clear);
        return true;
    });
    expectEachCaught("another layout", [](Barrier& barrier) {
        if (barrier.newLayout == Layout::Undefined) return false;
        barrier.newLayout = barrier.newLayout == Layout::General ? Layout::ShaderRead : Layout::General;
        return true;
    });
    expectEachCaught("waits for a use that was not", [](Barrier& barrier) {
        barrier.usesBefore |= barrier.usesBefore & bit(Use::Copy) ? bit(Use::Clear) : bit(Use::Copy);
        return !barrier.aliases;  // of those before in the same memory it may name more than there were
    });
    expectEachCaught("waits for nothing",
                     [](Barrier& barrier) { return std::exchange(barrier.usesBefore, 0) != 0; });
    expectEachCaught("availability forgotten", [](Barrier& barrier) {
        // Of those before in the same memory it need not know whether others made their writes available.
        return std::exchange(barrier.writeBefore, false) && !barrier.aliases;
    });
    expectEachCaught("one layer too few", [](Barrier& barrier) { return --barrier.range.layers > 0; });
    expectEachCaught("one level too few", [](Barrier& barrier) { return --barrier.range.mips > 0; });
}

}  // namespace
}  // namespace nephrite::graph::tests
