// The three modes.
#include "truth/estimator.h"

#include <glm/glm.hpp>
#include <map>
#include <numbers>

#include "scattering/fresnel.h"
#include "truth/flux_tree.h"
#include "truth/walk.h"

namespace nephrite::truth {
namespace {

const std::vector<std::string> colour{"R", "G", "B"};

/// As many of `photons` as connections leave light to them: a pilot measures its share.
std::uint32_t photonsWorthwhile(const World& world, std::uint64_t seed, std::uint32_t photons) {
    const PhotonSet pilot{1 << 12, seed, ~std::uint32_t{0}};
    constexpr double leastShare = 1.0 / 4096;
    const double share = traceUnconnectedLight(world, pilot, 1).share;
    return std::max(1U, static_cast<std::uint32_t>(photons * std::max(share, leastShare)));
}

/// Paths through the medium; each channel has its own.
class WalkEstimator : public Estimator {
  public:
    /// To be raised with every change here, to walks, photons, connections or the geometry under them, after
    /// which the same request gives another picture: kept references are then rendered anew.
    static constexpr std::uint32_t revision = 1;

    WalkEstimator(const World& world, std::uint64_t seed, Scatterings scatterings, std::uint32_t photons)
        : world_(world), seed_(seed), scatterings_(scatterings) {
        if (!hasUnconnectedLight(world)) return;
        radii_ = firstRadii(world);
        photons_ = photonsWorthwhile(world, seed, photons);
    }

    std::vector<std::string> channels() const override {
        std::vector<std::string> names = colour;
        if (scatterings_ == Scatterings::One) return names;
        for (const char* layer : {"single.", "multiple."})
            for (const std::string& channel : colour) names.push_back(layer + channel);
        return names;
    }
    std::uint32_t samplesPerRound() const override { return 4; }

    void beginRound(std::uint32_t first, std::uint32_t last, unsigned threads) override {
        firstOfRound_ = first;
        maps_.clear();
        for (std::uint32_t sample = first; photons_ > 0 && sample < last; ++sample) {
            std::vector<glm::dvec3> radii = radii_;
            for (glm::dvec3& radius : radii) radius *= radiusRatio(sample);
            maps_.emplace_back(world_, traceUnconnectedLight(world_, {photons_, seed_, sample}, threads),
                               radii);
        }
    }

    void sample(const CameraRay& ray, const SurfacePoint& seen, std::uint32_t pixel, std::uint32_t sample,
                std::span<double> values) const override {
        scattering::Random random(seed_, pixel, sample);
        const FluenceMap* unconnected = maps_.empty() ? nullptr : &maps_[sample - firstOfRound_];
        for (std::size_t c = 0; c < 3; ++c) {
            const ScatteredRadiance found = sampleRadiance(
                world_, seen, ray.ray.direction, static_cast<int>(c), scatterings_, random, unconnected);
            values[c] = found.single + found.multiple;
            if (scatterings_ == Scatterings::One) continue;
            values[3 + c] = found.single;
            values[6 + c] = found.multiple;
        }
    }

  private:
    const World& world_;
    std::uint64_t seed_;
    Scatterings scatterings_;
    std::uint32_t photons_ = 0;      ///< a light and sample
    std::vector<glm::dvec3> radii_;  ///< of the first sample, by object and channel
    std::uint32_t firstOfRound_ = 0;
    std::vector<FluenceMap> maps_;  ///< of the round's samples: each has its own, so they are independent
};

/// A layer of no thickness is skipped by depth, but it is still the first.
scattering::Medium firstLayer(const Material& material, int channel) {
    const MaterialLayer& layer = material.layers.front();
    return {layer.absorption.value[channel], layer.scattering.value[channel], material.g, material.eta};
}

/// What the dipole needs of a material: its first layer.
struct DipoleMaterial {
    ChannelDipoles kernels;
    double eta = 1;
    double diffuseTransmittance = 1;  ///< 1 - F_dr,ext
};

DipoleMaterial dipoleMaterial(const Material& material) {
    const auto dipole = [&](int channel) {
        return scattering::Dipole(firstLayer(material, channel), scattering::InternalReflection::exact);
    };
    return {{dipole(0), dipole(1), dipole(2)},
            material.eta,
            scattering::diffuseTransmittanceOutside(material.eta)};
}

/// Each sample gathers a set of flux points of its own.
class DipoleEstimator : public Estimator {
  public:
    /// To be raised with every change here, to the flux points, their tree or the kernel, after which the
    /// same request gives another picture.
    static constexpr std::uint32_t revision = 1;

    DipoleEstimator(const World& world, std::uint64_t seed, std::uint32_t fluxPoints)
        : world_(world), seed_(seed), fluxPoints_(fluxPoints) {
        for (std::uint32_t object = 0; object < world.geometry().objectCount(); ++object)
            if (world.materialOf(object).translucent())
                materials_.emplace(object, dipoleMaterial(world.materialOf(object)));
    }

    std::vector<std::string> channels() const override { return colour; }
    std::uint32_t samplesPerRound() const override { return 1; }

    void beginRound(std::uint32_t first, std::uint32_t, unsigned) override {
        trees_.clear();
        for (auto& points : enteringFlux(world_, fluxPoints_, seed_, first))
            trees_.emplace_back(std::move(points));
    }

    void sample(const CameraRay& ray, const SurfacePoint& seen, std::uint32_t, std::uint32_t,
                std::span<double> values) const override {
        const DipoleMaterial& material = materials_.at(seen.object);
        const double side = glm::dot(seen.facetNormal, ray.ray.direction) <= 0 ? 1 : -1;
        const double cosine = -side * glm::dot(seen.normal, ray.ray.direction);
        const double leaving = 1 - scattering::reflectanceFromOutside(cosine, material.eta);
        if (!(leaving > 0 && cosine > 0)) return;
        const glm::dvec3 exitance =
            trees_[seen.object].exitance(seen.position, material.kernels, GroupRule{});
        const glm::dvec3 radiance = exitance * (leaving / (std::numbers::pi * material.diffuseTransmittance));
        for (std::size_t c = 0; c < 3; ++c) values[c] = radiance[static_cast<int>(c)];
    }

  private:
    const World& world_;
    std::uint64_t seed_;
    std::uint32_t fluxPoints_;
    std::map<std::uint32_t, DipoleMaterial> materials_;
    std::vector<FluxTree> trees_;  ///< by object
};

}  // namespace

std::uint32_t revisionOf(Mode mode) {
    return mode == Mode::Dipole ? DipoleEstimator::revision : WalkEstimator::revision;
}

void requireSuitable(const scene::Scene& scene, Mode mode) {
    if (mode != Mode::Dipole) return;
    for (const scene::MaterialDescription& material : scene.description().materials) {
        if (material.layers.empty()) continue;
        const scene::LayerDescription& first = material.layers.front();
        if (first.absorptionTexture || first.scatteringTexture)
            throw InputError(first.where,
                             "the dipole is of a homogeneous medium, but this layer is textured");
    }
}

std::unique_ptr<Estimator> makeEstimator(const World& world, const EstimatorOptions& options,
                                         const scene::Scene& scene) {
    requireSuitable(scene, options.mode);
    if (options.mode == Mode::Dipole)
        return std::make_unique<DipoleEstimator>(world, options.seed, options.fluxPoints);
    const Scatterings scatterings = options.mode == Mode::Single ? Scatterings::One : Scatterings::Any;
    return std::make_unique<WalkEstimator>(world, options.seed, scatterings, options.photons);
}

}  // namespace nephrite::truth
