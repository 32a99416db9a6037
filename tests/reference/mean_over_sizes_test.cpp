// Which passes keep the mean of their picture from one size to the next: all consistent ones, and no literal
// multiple scattering.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <iostream>

#include "reference/dumped_frame.h"
#include "runtime/session.h"
#include "scratch_folder.h"

namespace nephrite::reference {
namespace {

/// A translucent and an opaque ball, both glossy, under a light beside the camera and a faint sky.
constexpr const char* scene = R"({ "millimetersPerUnit": 1,
  "camera": {"position": [0, 0, 40], "target": [0, 0, 0], "up": [0, 1, 0], "fovY": 36, "near": 1, "far": 1000},
  "lights": [{"type": "point", "position": [30, 30, 40], "intensity": [5000, 5000, 5000]}],
  "environment": {"radiance": [0.1, 0.1, 0.1]},
  "materials": {
    "apple": {"layers": [{"absorption": [0.003, 0.0034, 0.046], "scattering": [2.29, 2.39, 1.97]}],
              "g": 0, "eta": 1.3, "roughness": 0.5, "specular": true},
    "clay": {"diffuse": [0.6, 0.4, 0.3], "roughness": 0.5, "eta": 1.5, "specular": true}},
  "objects": [
    {"mesh": {"procedural": "sphere", "radius": 8}, "material": "apple", "transform": {"translate": [-3, 2, 0]}},
    {"mesh": {"procedural": "sphere", "radius": 3}, "material": "clay", "transform": {"translate": [7, -5, 6]}}] })";

constexpr std::array<std::uint32_t, 3> sizes{256, 512, 1024};

/// Mean of red, green and blue of each port at each of the sizes.
std::vector<std::array<double, sizes.size()>> meansOf(const std::string& graph,
                                                      const std::vector<std::string>& ports) {
    std::vector<std::array<double, sizes.size()>> means(ports.size());
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        runtime::SessionOptions options;
        options.scene = sharedScratchFolder().write("mean-over-sizes.json", scene);
        options.graph = graphFolder() / graph;
        options.size = {sizes[i], sizes[i]};
        options.dumps = ports;
        runtime::Session session(options);
        session.renderFrame(0);
        for (std::size_t port = 0; port < ports.size(); ++port) {
            const image::Image picture = session.read(ports[port]);
            double sum = 0;
            for (std::uint32_t y = 0; y < picture.height; ++y)
                for (std::uint32_t x = 0; x < picture.width; ++x)
                    for (std::uint32_t c = 0; c < 3; ++c) sum += static_cast<double>(picture.at(x, y, c));
            means[port][i] = sum / (3.0 * picture.width * picture.height);
        }
    }
    return means;
}

struct GraphPorts {
    const char* graph;
    std::vector<std::string> ports;
};

class ConsistentMean : public testing::TestWithParam<GraphPorts> {};

TEST_P(ConsistentMean, IsTheSameAtEverySize) {
    const auto& [graph, ports] = GetParam();
    const auto means = meansOf(graph, ports);
    for (std::size_t port = 0; port < ports.size(); ++port) {
        const auto& [small, middle, large] = means[port];
        std::cout << fmt::format("{} {}: mean {:.6f}, at 256 {:+.2f} %, at 1024 {:+.2f} %\n", graph,
                                 ports[port], middle, 100 * (small / middle - 1), 100 * (large / middle - 1));
        ASSERT_GT(middle, 0) << ports[port];
        EXPECT_NEAR(small / middle, 1, 0.01) << ports[port];
        EXPECT_NEAR(large / middle, 1, 0.01) << ports[port];
    }
}

INSTANTIATE_TEST_SUITE_P(
    Graphs, ConsistentMean,
    testing::Values(GraphPorts{"consistent.json",
                               {"multiple.radiance", "lambert.radiance", "specular.radiance",
                                "composite.color"}},
                    GraphPorts{"light-pyramid.json", {"single-scatter.radiance", "multiple.radiance"}},
                    GraphPorts{"screen-space.json", {"entering.irradiance", "multiple.radiance"}},
                    GraphPorts{"lambert-albedo.json", {"multiple.radiance"}}),
    [](const auto& instance) {
        std::string name = instance.param.graph;
        name.resize(name.find('.'));
        std::erase(name, '-');
        return name;
    });

/// The paper's resolution dependence: twelve pixels without an area lie nearer, and count as much, the finer
/// the picture is.
TEST(LiteralMean, OfMultipleScatteringGrowsWithTheSize) {
    const auto [small, middle, large] = meansOf("paper.json", {"dipole.radiance"}).front();
    std::cout << fmt::format("paper.json dipole.radiance: mean {:.6f}, at 256 {:+.1f} %, at 1024 {:+.1f} %\n",
                             middle, 100 * (small / middle - 1), 100 * (large / middle - 1));
    EXPECT_GT(middle / small, 1.01);
    EXPECT_GT(large / middle, 1.01);
}

}  // namespace
}  // namespace nephrite::reference
