// See synthetic_graph.h.
#include "graph/bench/synthetic_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <random>

namespace nephrite::graph {
namespace {

struct Size {
    int width;
    int height;
};
constexpr std::array<Size, 8> sizes{
    {{256, 256}, {480, 270}, {512, 512}, {640, 360}, {960, 540}, {1024, 1024}, {1280, 720}, {1920, 1080}}};
constexpr std::array<std::string_view, 3> inputNames{"a", "b", "c"};
constexpr std::array<std::string_view, 2> outputNames{"x", "y"};

std::string typeName(std::size_t reads, std::size_t writes, const Size& size) {
    return fmt::format("read{}-write{}-{}x{}", reads, writes, size.width, size.height);
}

PassType syntheticType(std::size_t reads, std::size_t writes, const Size& size) {
    PassType type;
    type.name = typeName(reads, writes, size);
    for (std::size_t i = 0; i < reads; ++i) {
        InputPort input;
        input.name = inputNames[i];
        type.inputs.push_back(input);
    }
    for (std::size_t i = 0; i < writes; ++i) {
        OutputPort output;
        output.name = outputNames[i];
        output.size = SizeRule{.kind = SizeRule::Kind::Absolute,
                               .width = Expression::constant(size.width),
                               .height = Expression::constant(size.height),
                               .like = {},
                               .where = {}};
        type.outputs.push_back(output);
    }
    return type;
}

/// One output of a node.
struct Result {
    Index node = noIndex;
    Index port = 0;
    friend bool operator==(const Result&, const Result&) = default;
};

/// A description that grows node by node.
class GraphMaker {
  public:
    GraphMaker(GraphShape shape, Index passes, std::uint64_t seed) : random_(seed), passes_(passes) {
        graph_.name = name(shape);
        graph_.file = fmt::format("{}.json", name(shape));
        graph_.nodes.reserve(passes);
        isRead_.reserve(passes);
    }

    GraphDescription make(GraphShape shape) {
        switch (shape) {
            case GraphShape::Random:
                makeRandom();
                break;
            case GraphShape::Chain:
                makeChain(passes_);
                break;
            case GraphShape::Ladder:
                makeLadder();
                break;
            case GraphShape::Fan:
                makeFan();
                break;
            case GraphShape::DeadChains:
                makeDeadChains();
                break;
        }
        return std::move(graph_);
    }

  private:
    static constexpr std::size_t window = 32;

    Index below(std::size_t bound) { return static_cast<Index>(random_() % bound); }
    Index count() const { return static_cast<Index>(graph_.nodes.size()); }
    static Result first(Index node) { return {node, 0}; }

    Index add(const std::vector<Result>& reads, std::size_t writes = 1) {
        NodeDescription node;
        node.name = fmt::format("p{}", count());
        node.passType = typeName(reads.size(), writes, sizes[below(sizes.size())]);
        for (std::size_t i = 0; i < reads.size(); ++i) {
            PortReference reference;
            reference.node = graph_.nodes[reads[i].node].name;
            reference.port = outputNames[reads[i].port];
            node.inputs.emplace_back(inputNames[i], reference);
        }
        graph_.nodes.push_back(std::move(node));
        isRead_.push_back(0);
        return count() - 1;
    }

    void addOutput(Index node) {
        PortReference reference;
        reference.node = graph_.nodes[node].name;
        reference.port = outputNames[0];
        graph_.outputs.emplace_back(fmt::format("out{}", graph_.outputs.size()), reference);
    }

    void makeChain(Index length) {
        Index last = add({});
        for (Index i = 1; i < length; ++i) last = add({first(last)});
        addOutput(last);
    }

    void makeLadder() {
        std::array<Index, 2> ends{add({}), 0};
        ends[1] = passes_ > 1 ? add({first(ends[0])}) : ends[0];
        while (count() < passes_) {
            const std::array<Index, 2> before = ends;
            ends[0] = add({first(before[0]), first(before[1])});
            if (count() < passes_) ends[1] = add({first(before[1]), first(before[0])});
        }
        addOutput(ends[0]);
        if (ends[1] != ends[0]) addOutput(ends[1]);
    }

    void makeFan() {
        const Index source = add({});
        std::vector<Index> ends;
        const Index readers = passes_ / 2;
        for (Index i = 0; i < readers; ++i) ends.push_back(add({first(source)}));
        for (std::size_t i = 0; i + 1 < ends.size() && count() < passes_; i += 2) {
            ends.push_back(add({first(ends[i]), first(ends[i + 1])}));
        }
        while (count() < passes_) ends.push_back(add({first(ends.empty() ? source : ends.back())}));
        addOutput(ends.empty() ? source : ends.back());
    }

    void makeDeadChains() {
        const Index live = (passes_ + 1) / 2;
        makeChain(live);
        while (count() < passes_) {
            Index last = below(live);
            for (Index length = 1 + below(20); length > 0 && count() < passes_; --length)
                last = add({first(last)});
        }
    }

    /// Dead passes read live and dead results, live ones only live results; and every live result but the
    /// last ones is read before it is too old, so that just the passes meant to be dead are.
    void makeRandom() {
        const std::vector<std::uint8_t> isDead = chooseDead();
        for (Index pass = 0; pass < passes_; ++pass) {
            const std::size_t writes = 1 + below(2);
            std::vector<Result>& results = isDead[pass] != 0 ? dead_ : live_;
            const Index node = add(isDead[pass] != 0 ? readsOfDead() : readsOfLive(writes), writes);
            for (Index port = 0; port < writes; ++port) results.push_back({node, port});
        }
        for (Index pass = 0; pass < passes_; ++pass) {
            if (isDead[pass] == 0 && isRead_[pass] == 0) addOutput(pass);
        }
    }

    std::vector<std::uint8_t> chooseDead() {
        std::vector<std::uint8_t> isDead(passes_, 0);
        std::fill_n(isDead.begin(), std::size_t{passes_} * 3 / 10, std::uint8_t{1});
        std::shuffle(isDead.begin(), isDead.end(), random_);
        // A dead chain begins at something alive.
        std::iter_swap(isDead.begin(), std::find(isDead.begin(), isDead.end(), 0));
        return isDead;
    }

    std::vector<Result> readsOfLive(std::size_t writes) {
        const std::size_t wanted = 1 + below(3);
        std::vector<Result> reads;
        const std::size_t oldest = live_.size() - std::min(live_.size(), window);
        const std::size_t kept = live_.size() - std::min(live_.size(), window - writes);
        for (std::size_t i = oldest; i < kept && reads.size() < wanted; ++i) {
            if (isRead_[live_[i].node] != 0) continue;
            reads.push_back(live_[i]);
            isRead_[live_[i].node] = 1;
        }
        addReads(reads, wanted);
        for (const Result& read : reads) isRead_[read.node] = 1;
        return reads;
    }

    /// Mostly the dead chain goes on.
    std::vector<Result> readsOfDead() {
        std::vector<Result> reads;
        if (!dead_.empty() && below(8) != 0)
            reads.push_back(dead_[dead_.size() - 1 - below(std::min<std::size_t>(dead_.size(), 4))]);
        addReads(reads, 1 + below(3));
        return reads;
    }

    /// Adds live results until there are `wanted`, or fewer if one was chosen twice.
    void addReads(std::vector<Result>& reads, std::size_t wanted) {
        const std::size_t recent = std::min(live_.size(), window);
        if (recent == 0) return;
        for (std::size_t i = reads.size(); i < wanted; ++i) {
            const Result result = live_[live_.size() - 1 - below(recent)];
            if (std::find(reads.begin(), reads.end(), result) == reads.end()) reads.push_back(result);
        }
    }

    std::mt19937_64 random_;
    Index passes_;
    GraphDescription graph_;
    std::vector<std::uint8_t> isRead_;  ///< by node: something alive reads it
    std::vector<Result> live_;
    std::vector<Result> dead_;
};

}  // namespace

std::string_view name(GraphShape shape) {
    constexpr std::array<std::string_view, graphShapes.size()> names{"random", "chain", "ladder", "fan",
                                                                     "dead-chains"};
    return names[static_cast<std::size_t>(shape)];
}

std::optional<GraphShape> graphShapeNamed(std::string_view wanted) {
    for (const GraphShape shape : graphShapes) {
        if (name(shape) == wanted) return shape;
    }
    return std::nullopt;
}

PassLibrary syntheticTypes() {
    PassLibrary types;
    for (std::size_t reads = 0; reads <= inputNames.size(); ++reads) {
        for (std::size_t writes = 1; writes <= outputNames.size(); ++writes) {
            for (const Size& size : sizes) types.add(syntheticType(reads, writes, size));
        }
    }
    return types;
}

std::shared_ptr<const LinkedGraph> syntheticGraph(GraphShape shape, Index passes, std::uint64_t seed,
                                                  const PassLibrary& types) {
    return link(GraphMaker(shape, passes, seed).make(shape), types);
}

}  // namespace nephrite::graph
