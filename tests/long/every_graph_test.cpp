// Every graph with every scene at the paper's two sizes.
#include "runtime/every_graph.h"

namespace nephrite::runtime {
namespace {

TEST(EveryGraph, EverySceneAtBothSizesIsCleanAndFinite) {
    test::renderEveryGraph({512, 1024});
}

}  // namespace
}  // namespace nephrite::runtime
