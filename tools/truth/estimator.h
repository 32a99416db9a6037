// What a reference renders: the values of one sample of one pixel, in rounds of samples.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "truth/camera.h"
#include "truth/world.h"

namespace nephrite::truth {

enum class Mode { Single, Dipole, Volume };

class Estimator {
  public:
    virtual ~Estimator() = default;

    /// Names of the values of a sample, as the picture's channels.
    virtual std::vector<std::string> channels() const = 0;
    /// How many samples a round has; the last round may have fewer.
    virtual std::uint32_t samplesPerRound() const = 0;
    /// Called before the samples `first` to `last` - 1, at most a round, are asked for, while none is under
    /// way. What it prepares may not depend on the number of threads.
    virtual void beginRound(std::uint32_t first, std::uint32_t last, unsigned threads) = 0;
    /// Values of sample number `sample` of pixel (x, y), which shows `seen`, a point of a translucent object.
    /// Depends on nothing else; called by several threads at once.
    virtual void sample(const CameraRay& ray, const SurfacePoint& seen, std::uint32_t pixel,
                        std::uint32_t sample, std::span<double> values) const = 0;
};

/// The revision of the estimator behind a mode. It is part of a picture's record, so that references of an
/// older one are not taken for this one's.
std::uint32_t revisionOf(Mode mode);

/// Settings of the estimators.
struct EstimatorOptions {
    Mode mode = Mode::Volume;
    std::uint64_t seed = 1;
    std::uint32_t fluxPoints = 1 << 20;  ///< dipole: a light and sample
    std::uint32_t photons = 1 << 18;     ///< single, volume: a light and sample, at most
};

/// Throws InputError if the mode is not defined for the scene: the dipole, which is of a homogeneous medium,
/// meets a textured first layer.
void requireSuitable(const scene::Scene& scene, Mode mode);

/// The world, which is of the scene, must outlive it. Throws as requireSuitable().
std::unique_ptr<Estimator> makeEstimator(const World& world, const EstimatorOptions& options,
                                         const scene::Scene& scene);

}  // namespace nephrite::truth
