// Volumetric Monte Carlo against what is known exactly: half spaces, furnaces, single scattering.
#include "truth/walk.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "scattering/fresnel.h"
#include "scattering/phase.h"
#include "scattering/quadrature.h"
#include "statistics.h"
#include "support.h"

namespace nephrite::truth {
namespace {

using statistics::Family;
using statistics::meanTest;
using test::layer;
using test::material;

void addTest(Family& family, const std::string& name, const scattering::RunningStatistics& estimate,
             double expected) {
    family.add(name, meanTest(estimate.mean(), estimate.standardError(), estimate.count(), expected));
}

/// Chandrasekhar's H function of an isotropic half space, by iteration at the nodes of a quadrature
/// ("Radiative Transfer", 1960, chapter V).
class HFunction {
  public:
    explicit HFunction(double albedo) : albedo_(albedo) {
        for (std::size_t i = 0; i < nodes; ++i) {
            const double x = (static_cast<double>(i) + 0.5) / nodes;
            mu_[i] = x * x;
            weight_[i] = 2 * x / nodes;
        }
        values_.fill(1);
        for (int step = 0; step < 200; ++step) {
            std::array<double, nodes> next{};
            for (std::size_t i = 0; i < nodes; ++i) next[i] = at(mu_[i]);
            values_ = next;
        }
    }
    double at(double mu) const {
        double sum = 0;
        for (std::size_t i = 0; i < nodes; ++i) sum += weight_[i] * mu_[i] * values_[i] / (mu + mu_[i]);
        return 1 / (std::sqrt(1 - albedo_) + albedo_ / 2 * sum);
    }

  private:
    static constexpr std::size_t nodes = 400;
    double albedo_;
    std::array<double, nodes> mu_{}, weight_{}, values_{};
};

/// Radiance of an isotropic half space that light of irradiance 1 across its beam falls on; no boundary.
double halfSpaceRadiance(double albedo, double lightCosine, double viewCosine) {
    const HFunction h(albedo);
    return albedo / (4 * std::numbers::pi) * lightCosine / (lightCosine + viewCosine) * h.at(lightCosine) *
           h.at(viewCosine);
}

struct Slab {
    scene::Scene scene;
    World world;
    Slab(const std::string& material, double lightCosine)
        : scene(test::sceneOf(test::slabScene(material, lightCosine))), world(scene, 0) {}

    /// The radiance towards a viewer at this angle, at right angles to the light's plane.
    scattering::RunningStatistics radiance(double viewCosine, Scatterings scatterings, std::uint64_t count) {
        const double sine = std::sqrt(1 - viewCosine * viewCosine);
        const test::Sight sight = test::look(world, {0.3, 0, 0.2}, {0, viewCosine, sine});
        return test::estimate(17, count, [&](scattering::Random& random) {
            const auto found = sampleRadiance(world, sight.seen, sight.view, 0, scatterings, random);
            return found.single + found.multiple;
        });
    }
};

TEST(Walk, HalfSpaceIsChandrasekhars) {
    Family family;
    for (const double albedo : {0.5, 0.9, 0.99}) {
        Slab slab(material(layer(1 - albedo, albedo), 1), 0.6);
        addTest(family, "albedo " + std::to_string(albedo), slab.radiance(0.8, Scatterings::Any, 6000),
                halfSpaceRadiance(albedo, 0.6, 0.8));
    }
    EXPECT_TRUE(family.holds());
}

TEST(Walk, LayersAttenuateByDepth) {
    Family family;
    const double through = std::exp(-0.8 * 0.5 * (1 / 0.6 + 1 / 0.8));
    Slab filtered(material(layer(0.8, 0, "0.5") + "," + layer(0.2, 0.8), 1), 0.6);
    addTest(family, "absorbing layer on top", filtered.radiance(0.8, Scatterings::Any, 6000),
            through * halfSpaceRadiance(0.8, 0.6, 0.8));
    Slab divided(material(layer(0.2, 0.8, "0.3") + "," + layer(0.1, 0.4, "1e-6") + "," + layer(0.2, 0.8), 1),
                 0.6);
    addTest(family, "layers of one medium", divided.radiance(0.8, Scatterings::Any, 6000),
            halfSpaceRadiance(0.8, 0.6, 0.8));
    EXPECT_TRUE(family.holds());
}

/// Model page, single scattering: (1-F_o)/eta^2 albedo p (1-F_i) mu_i / (c_i + c_o).
double singleRadiance(double albedo, double g, double eta, double lightCosine, double viewCosine) {
    const double in = scattering::refractedCosineInside(lightCosine, eta);
    const double out = scattering::refractedCosineInside(viewCosine, eta);
    const double cosine = -in * out;  // the planes of light and view are at right angles
    return (1 - scattering::reflectanceFromOutside(viewCosine, eta)) / (eta * eta) * albedo *
           scattering::henyeyGreenstein(cosine, g) *
           (1 - scattering::reflectanceFromOutside(lightCosine, eta)) * lightCosine / (in + out);
}

TEST(Walk, SingleScatteringHasItsClosedForm) {
    Family family;
    for (const double eta : {1.0, 1.3, 1.5})
        for (const double g : {0.0, 0.6}) {
            Slab slab(material(layer(0.4, 1.2), eta, g), 0.5);
            addTest(family, "eta " + std::to_string(eta), slab.radiance(0.7, Scatterings::One, 20000),
                    singleRadiance(0.75, g, eta, 0.5, 0.7));
        }
    EXPECT_TRUE(family.holds());
}

TEST(Walk, AWrongClosedFormIsNoticed) {
    Slab slab(material(layer(0.4, 1.2), 1.3), 0.5);
    Family family;
    addTest(family, "without eta^2", slab.radiance(0.7, Scatterings::One, 20000),
            1.69 * singleRadiance(0.75, 0, 1.3, 0.5, 0.7));
    EXPECT_FALSE(family.holds());
}

/// Giovanelli 1955: eta 1.5, albedo 0.9, isotropic, perpendicular light: 0.2600 with the surface's 0.04.
TEST(Walk, GlassyHalfSpaceIsGiovanellis) {
    Slab slab(material(layer(0.1, 0.9), 1.5), 1);
    const auto reflectance = test::estimate(3, 30000, [&](scattering::Random& random) {
        const double cosine = std::sqrt(1 - random.uniform());
        const test::Sight sight =
            test::look(slab.world, {0.3, 0, 0.2}, {std::sqrt(1 - cosine * cosine), cosine, 0});
        const auto found = sampleRadiance(slab.world, sight.seen, sight.view, 1, Scatterings::Any, random);
        return std::numbers::pi * (found.single + found.multiple);
    });
    EXPECT_LT(reflectance.standardError(), 0.002);
    EXPECT_NEAR(reflectance.mean(), 0.22, 3 * reflectance.standardError() + 0.00005);
}

/// Where all surroundings shine alike and nothing absorbs, everything looks as bright as they.
TEST(Walk, WhiteFurnaceLosesNothing) {
    for (const double eta : {1.0, 1.3}) {
        const auto scene = test::sceneOf("{" + test::anyCamera +
                                         R"json(, "environment": {"radiance": [1, 1, 1]}, "objects": [
                       {"mesh": {"procedural": "sphere", "radius": 10}, "material": )json" +
                                         material(layer(0, 2), eta, 0.3) + "}]}");
        const World world(scene, 0);
        const test::Sight sight = test::look(world, {1, 2, 10}, {0.3, 0, 1});
        const double cosine = -glm::dot(sight.seen.normal, sight.view);
        const double entering = 1 - scattering::reflectanceFromOutside(cosine, eta);
        const auto radiance = test::estimate(5, 1000, [&](scattering::Random& random) {
            const auto found = sampleRadiance(world, sight.seen, sight.view, 2, Scatterings::Any, random);
            return found.single + found.multiple;
        });
        // Whatever way a path takes, it brings the same.
        EXPECT_NEAR(radiance.mean(), entering, 1e-12);
        EXPECT_LT(radiance.standardError(), 1e-12);
    }
}

/// A scattering slab over a pile of clear ones: what goes down meets more boundaries than roulette leaves
/// alone, and still brings the surroundings' light.
TEST(Walk, RouletteOfManyBoundariesLosesNothing) {
    std::string objects;
    const auto addSlab = [&](double thickness, double y, const std::string& layers) {
        objects += (objects.empty() ? "" : ",") +
                   std::string(R"({"mesh": {"procedural": "slab", "size": [4000, )") +
                   std::to_string(thickness) + R"(, 4000]}, "transform": {"translate": [0, )" +
                   std::to_string(y) + R"(, 0]}, "material": )" + material(layers, 1) + "}";
    };
    addSlab(2, 0, layer(0, 1));
    for (int i = 0; i < 20; ++i) addSlab(0.5, -3 - i, layer(0, 0));
    const auto scene = test::sceneOf(
        "{" + test::anyCamera + R"(, "environment": {"radiance": [1, 1, 1]}, "objects": [)" + objects + "]}");
    const World world(scene, 0);
    const test::Sight sight = test::look(world, {0.3, 1, 0.2}, {0, 1, 0});
    const auto found = test::estimate(21, 4000, [&](scattering::Random& random) {
        const auto one = sampleRadiance(world, sight.seen, sight.view, 1, Scatterings::Any, random);
        return one.single + one.multiple;
    });
    // Light that was not scattered is no part of it.
    Family family;
    addTest(family, "pile", found, 1 - std::exp(-2));
    EXPECT_TRUE(family.holds());
    EXPECT_LT(found.standardError(), 0.04);
}

TEST(Walk, ScalingTheSceneAndTheCoefficientsChangesNothing) {
    const auto radiance = [](double scale) {
        const std::string s = std::to_string(scale);
        const auto scene =
            test::sceneOf(R"({"millimetersPerUnit": )" + s + R"(, "camera": {"position": [0, 0, 40]},
               "lights": [{"type": "point", "position": [30, 30, 10], "intensity": [1, 1, 1]}],
               "objects": [{"mesh": {"procedural": "sphere", "radius": 10}, "material": )" +
                          material(layer(0.1 / scale, 2 / scale), 1.3) + "}]}");
        const World world(scene, 0);
        const test::Sight sight = test::look(world, scale * glm::dvec3{2, 4, 9}, {0, 0, 1});
        const auto found = test::estimate(9, 2000, [&](scattering::Random& random) {
            const auto one = sampleRadiance(world, sight.seen, sight.view, 0, Scatterings::Any, random);
            return (one.single + one.multiple) * scale * scale;
        });
        return found;
    };
    const auto usual = radiance(1);
    for (const double scale : {0.01, 100.0}) {
        const auto scaled = radiance(scale);
        EXPECT_NEAR(scaled.mean() / usual.mean(), 1, 0.02) << scale;
    }
}

}  // namespace
}  // namespace nephrite::truth
