// Renders the points of one scene: their pictures, the times of their frames, and of their passes.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "graph/plan.h"
#include "image/image.h"
#include "pareto/points.h"
#include "pareto/progress.h"
#include "pareto/results.h"
#include "pareto/suite.h"

namespace nephrite::pareto {

/// What all frames of a suite share.
struct FrameSettings {
    graph::Extent size{512, 512};
    std::uint32_t frames = 30;
    std::uint32_t warmup = 3;
    std::string device;  ///< part of its name; empty: the best there is
};

/// The pictures that a timed point is compared by, by port, which the graph must have; one frame. Throws
/// InputError, naming the method too, if the graph is wrong; RunError.
std::map<std::string, image::Image> renderPictures(const Point& point, const std::filesystem::path& scene,
                                                   const FrameSettings& settings);

/// Times of a scene's points.
struct SceneTimes {
    std::vector<std::vector<double>> wallMs;      ///< by point and round; empty for a sum of references
    std::vector<std::vector<PassResult>> passes;  ///< by point
    std::vector<std::vector<std::uint32_t>>
        rounds;          ///< the points in the order in which each round rendered them
    std::string device;  ///< as Vulkan names it
    std::string driver;
};

/// Renders every timed point of a scene, interleaved frame by frame in the orders of roundOrder(): first the
/// warm-up, then `frames` rounds whose wall times count, then the same with a full barrier around every pass
/// for the times of the passes. All passes that the picture needs run in every frame, also where nothing has
/// changed. Throws as renderPictures, and RunError when told to stop.
SceneTimes measureTimes(const std::vector<Point>& points, const std::filesystem::path& scene,
                        const FrameSettings& settings, const Progress& progress);

}  // namespace nephrite::pareto
