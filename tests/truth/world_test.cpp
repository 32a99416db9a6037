// Free paths through layers against their exact density, and the estimate of how much light gets through.
#include "truth/world.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "statistics.h"
#include "support.h"

namespace nephrite::truth {
namespace {

using statistics::Family;

/// Three layers under a plane, met by a ray that goes down at a slant.
class Layers : public testing::Test {
  protected:
    static constexpr double cosine = 0.8;
    static constexpr double farthest = 8;  // mm along the ray

    struct Part {
        double end;  ///< mm along the ray
        double extinction;
        double albedo;
    };
    static constexpr std::array<Part, 3> parts{
        {{0.5 / cosine, 2, 0.75}, {1.5 / cosine, 0.25, 0.2}, {1e9, 1, 0.9}}};

    static const Part& partAt(double distance) {
        std::size_t part = 0;
        while (distance > parts.at(part).end) ++part;
        return parts.at(part);
    }

    static double opticalDepth(double distance) {
        double depth = 0, start = 0;
        for (const Part& part : parts) {
            depth += part.extinction * (std::min(distance, part.end) - std::min(distance, start));
            start = part.end;
        }
        return depth;
    }

    /// Edges of bins none of which reaches into two layers.
    static std::vector<double> edges() {
        std::vector<double> all;
        double start = 0;
        for (const Part& part : parts) {
            const double end = std::min(part.end, farthest);
            for (const double edge : statistics::evenEdges(start, end, 12))
                if (all.empty() || edge > all.back()) all.push_back(edge);
            start = end;
        }
        return all;
    }

    static std::string layersText() {
        return test::layer(0.5, 1.5, "0.5") + "," + test::layer(0.2, 0.05, "1") + "," + test::layer(0.1, 0.9);
    }

    /// Chi-squared test of `count` free paths against a density in 1/mm.
    template<class Density>
    double pathTest(std::uint64_t seed, Density density) const {
        scattering::Random random(seed, 0, 0);
        return statistics::sampleTest(
            [&] {
                const auto collision = world_.collide(ray_, farthest, 0, 0, random);
                return collision ? collision->distance : 2 * farthest;
            },
            density, edges(), 60000);
    }

    scene::Scene scene_ = test::sceneOf(test::slabScene(test::material(layersText(), 1), 1));
    World world_{scene_, 0};
    Ray ray_{{0.3, 0, 0.2}, {0, -cosine, std::sqrt(1 - cosine * cosine)}};
};

TEST_F(Layers, FreePathsHaveTheirDensity) {
    Family right;
    right.add("by layers",
              pathTest(1, [](double s) { return partAt(s).extinction * std::exp(-opticalDepth(s)); }));
    EXPECT_TRUE(right.holds());

    // As if the second layer were of the third's extinction, a little less.
    Family wrong;
    wrong.add("second layer 0.3/mm", pathTest(1, [](double s) {
                  const double added = 0.05 * std::clamp(s - parts[0].end, 0.0, parts[1].end - parts[0].end);
                  const bool second = s > parts[0].end && s <= parts[1].end;
                  return (partAt(s).extinction + (second ? 0.05 : 0)) * std::exp(-opticalDepth(s) - added);
              }));
    EXPECT_FALSE(wrong.holds());
}

TEST_F(Layers, CollisionsHaveTheirLayersAlbedo) {
    scattering::Random random(2, 0, 0);
    for (int i = 0; i < 500; ++i)
        if (const auto collision = world_.collide(ray_, farthest, 0, 1, random)) {
            EXPECT_NEAR(collision->albedo, partAt(collision->distance).albedo, 1e-6);
        }
}

TEST_F(Layers, TransmittanceIsUnbiased) {
    const auto test = [&](double length, double opticalDepth_) {
        const auto found = test::estimate(3, 20000, [&](scattering::Random& random) {
            return world_.transmittance(ray_, length, 0, 2, random);
        });
        return statistics::meanTest(found.mean(), found.standardError(), found.count(),
                                    std::exp(-opticalDepth_));
    };
    Family right;
    for (const double length : {0.3, 1.0, 3.0, 8.0})
        right.add(std::to_string(length), test(length, opticalDepth(length)));
    EXPECT_TRUE(right.holds());

    Family wrong;
    wrong.add("a little more", test(3, opticalDepth(3) + 0.1));
    EXPECT_FALSE(wrong.holds());
}

TEST(Homogeneous, FreePathsAreExponential) {
    const auto scene = test::sceneOf(test::slabScene(test::material(test::layer(0.4, 1.1), 1), 1));
    const World world(scene, 0);
    const auto pathTest = [&](double extinction) {
        scattering::Random random(4, 0, 0);
        return statistics::sampleTest(
            [&] {
                const auto collision = world.collide({{0, 0, 0}, {0, -1, 0}}, 4, 0, 0, random);
                return collision ? collision->distance : 8;
            },
            [&](double s) { return extinction * std::exp(-extinction * s); }, statistics::evenEdges(0, 4, 40),
            100000);
    };
    Family right;
    right.add("sigma_t", pathTest(1.5));
    EXPECT_TRUE(right.holds());
    Family wrong;
    wrong.add("3 % more", pathTest(1.545));
    EXPECT_FALSE(wrong.holds());
}

}  // namespace
}  // namespace nephrite::truth
