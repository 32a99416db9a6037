// Every graph with every scene, small; tests/long has the paper's sizes.
#include "every_graph.h"

namespace nephrite::runtime {
namespace {

TEST(EveryGraphSmall, EverySceneIsCleanAndFinite) {
    test::renderEveryGraph({48}, {"lightSize=64"});
}

}  // namespace
}  // namespace nephrite::runtime
