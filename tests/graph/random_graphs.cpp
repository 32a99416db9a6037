// See random_graphs.h.
#include "graph/random_graphs.h"

#include <array>
#include <random>

#include "graph/graph_builder.h"
#include "graph/small_library.h"

namespace nephrite::graph::tests {
namespace {

class RandomGraph {
  public:
    RandomGraph(std::uint64_t seed, Index mostNodes) : random_(seed), nodeCount_(1 + below(mostNodes)) {}

    CompileRequest request() {
        for (Index i = 0; i < nodeCount_; ++i) addNode();
        for (Index i = 0; i < 1 + below(3); ++i) addOutput();
        CompileRequest result;
        result.graph = builder_.build();
        result.view = {1 + below(64), 1 + below(64)};
        result.facts.lightViews = below(3);
        result.inputReads = oneIn(2) ? InputReads::StorageImage : InputReads::SampledImage;
        result.skip = !oneIn(4);
        return result;
    }

  private:
    std::uint32_t below(std::uint32_t bound) {
        return std::uniform_int_distribution<std::uint32_t>(0, bound - 1)(random_);
    }
    bool oneIn(std::uint32_t count) { return below(count) == 0; }

    PassType randomType() {
        static constexpr std::array kinds{PassKind::Pixel, PassKind::Compute, PassKind::Raster,
                                          PassKind::Native};
        PassType type = passType("t", kinds[below(kinds.size())], below(4), 1 + below(3));
        const bool isRaster = type.kind == PassKind::Raster;
        for (OutputPort& output : type.outputs) {
            if (!isRaster && oneIn(4)) {
                output.bufferElement = "vec4";
                output.bufferCount = Expression::constant(below(4));
            } else if (!isRaster && oneIn(4)) {
                output.mips = Expression::constant(0);
                output.layers = Expression::constant(1 + below(3));
            }
        }
        if (isRaster && oneIn(2)) type.outputs.back().format = Format::d32f;
        if (oneIn(8)) type.skipWhen = Expression::constant(oneIn(2) ? 1 : 0);
        if (!type.inputs.empty() && oneIn(6)) type.skipWhen = expression("inputs.in0.neutral");
        for (InputPort& input : type.inputs) {
            if (oneIn(4)) input.neededWhen = Expression::constant(oneIn(2) ? 1 : 0);
        }
        type.sideEffect = oneIn(15);
        return type;
    }

    void addNode() {
        const PassType& type = builder_.addType(randomType());
        std::vector<LinkedInput> sources;
        for (std::size_t i = 0; i < type.inputs.size(); ++i) {
            sources.push_back(types_.empty() || oneIn(6) ? LinkedInput{} : randomPort());
        }
        NodeDescription description;
        description.forEachLight = oneIn(4);
        if (oneIn(10)) description.view = ViewKind::Light;
        if (oneIn(10)) description.when = Expression::constant(oneIn(2) ? 1 : 0);
        builder_.addNode(type, sources, description);
        types_.push_back(&type);
    }

    /// Mostly a port of a node added lately, so that graphs are deep and not only wide.
    LinkedInput randomPort() {
        const auto count = static_cast<Index>(types_.size());
        const Index node = oneIn(3) ? below(count) : count - 1 - below(std::min<Index>(count, 3));
        return {node, below(static_cast<Index>(types_[node]->outputs.size()))};
    }

    void addOutput() {
        const LinkedInput port = randomPort();
        builder_.addOutput(port.sourceNode, port.sourcePort);
    }

    std::mt19937_64 random_;
    Index nodeCount_;
    GraphBuilder builder_;
    std::vector<const PassType*> types_;
};

}  // namespace

CompileRequest randomRequest(std::uint64_t seed, Index mostNodes) {
    return RandomGraph(seed, mostNodes).request();
}

}  // namespace nephrite::graph::tests
