// Paths through stacks of layers.
#include "reference/literal/layer_path.h"

#include <gtest/gtest.h>

#include <numeric>

namespace nephrite::reference {
namespace {

const std::vector<double> threeLayers{0.5, 1, 1e30};

TEST(LayerPath, PartsAddUpToTheLength) {
    for (const double length : {0.0, 0.1, 0.5, 0.9, 3.0, 100.0}) {
        for (const double cosine : {1e-6, 0.2, 0.7, 1.0}) {
            const auto path = pathThroughLayers(length, cosine, threeLayers);
            EXPECT_NEAR(std::accumulate(path.begin(), path.end(), 0.0), length, 1e-12 * length);
            for (const double part : path) EXPECT_GE(part, 0);
        }
    }
}

TEST(LayerPath, CrossesALayerInThicknessOverCosine) {
    const auto path = pathThroughLayers(10, 0.5, threeLayers);
    EXPECT_DOUBLE_EQ(path[0], 1);
    EXPECT_DOUBLE_EQ(path[1], 2);
    EXPECT_DOUBLE_EQ(path[2], 7);
}

TEST(LayerPath, EndsInTheLayerItReaches) {
    const auto path = pathThroughLayers(1.5, 0.5, threeLayers);
    EXPECT_DOUBLE_EQ(path[0], 1);
    EXPECT_DOUBLE_EQ(path[1], 0.5);
    EXPECT_DOUBLE_EQ(path[2], 0);
}

TEST(LayerPath, LeavesOutLayersOfNoThickness) {
    const std::vector<double> thickness{0, 0, 1e30};
    const auto path = pathThroughLayers(2, 0.5, thickness);
    EXPECT_EQ(path, (std::vector<double>{0, 0, 2}));
}

TEST(LayerPath, GivesTheLastLayerWhatIsLeftOverEvenIfItIsFinite) {
    const std::vector<double> slab{0.25};
    EXPECT_DOUBLE_EQ(pathThroughLayers(3, 1, slab)[0], 3);
}

TEST(LayerPath, FindsTheLayerAtADepth) {
    EXPECT_EQ(layerAtDepth(0, threeLayers), 0U);
    EXPECT_EQ(layerAtDepth(0.49, threeLayers), 0U);
    EXPECT_EQ(layerAtDepth(0.5, threeLayers), 1U);
    EXPECT_EQ(layerAtDepth(1.6, threeLayers), 2U);
    EXPECT_EQ(layerAtDepth(7, std::vector<double>{1, 1}), 1U);
}

TEST(LayerPath, OpticalDepthIsTheSumOverLayers) {
    const std::vector<glm::dvec3> coefficient{{1, 2, 3}, {4, 5, 6}};
    const std::vector<double> path{0.5, 0.25};
    EXPECT_EQ(opticalDepth(coefficient, path), glm::dvec3(1.5, 2.25, 3));
}

}  // namespace
}  // namespace nephrite::reference
