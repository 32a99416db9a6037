// What a run of a suite found: plain data, from which the files are written.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "image/exr.h"
#include "image/metrics/metrics.h"
#include "pareto/pass_times.h"
#include "truth/estimator.h"

namespace nephrite::pareto {

/// relRMSE of the worst channel without the noise of the reference; with it where there is but one half of
/// the reference or the estimate is not above 0.
double errorOf(const image::Metrics& metrics);

/// A picture held against a reference.
struct ComparisonResult {
    truth::Mode reference = truth::Mode::Volume;
    std::string port;
    image::Metrics metrics;
    bool isOnFront = false;  ///< among the points of the scene held against the same reference

    double error() const { return errorOf(metrics); }
};

/// What was measured of a point. A sum of references has no times.
struct PointResult {
    std::string name;
    std::string method;
    std::filesystem::path graph;                                  ///< empty: a sum of references
    std::vector<std::pair<std::string, std::string>> parameters;  ///< varied ones
    std::vector<std::string> settings;                            ///< all that were set
    bool skip = true;
    bool isFirst = true;         ///< the first combination of its method's values
    std::vector<double> wallMs;  ///< of each round's frame
    std::optional<double>
        ratioToBaseline;  ///< median of the ratios of its frame to the baseline's, round by round
    std::vector<PassResult> passes;
    std::vector<ComparisonResult> comparisons;

    bool isTimed() const { return !wallMs.empty(); }
};

/// A reference and how noisy it is.
struct ReferenceResult {
    truth::Mode mode = truth::Mode::Volume;
    std::array<std::filesystem::path, 2> files;  ///< the two halves
    image::Metadata record;                      ///< of the first half
    std::array<double, 3>
        noise{};  ///< of the halves' mean: its standard error over its mean, by channel, lit pixels
};

struct SceneResult {
    std::string name;
    std::filesystem::path file;
    std::uint32_t bins = 1;
    std::vector<ReferenceResult> references;
    std::vector<PointResult> points;
    std::vector<std::vector<std::uint32_t>>
        rounds;  ///< the points in the order in which each round rendered them
};

struct LeftOutScene {
    std::string name;
    std::string why;
};

struct SuiteResult {
    std::string suite;
    std::string baseline;
    std::string device;
    std::string driver;
    std::string commit;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t frames = 0;
    std::uint32_t warmup = 0;
    std::vector<SceneResult> scenes;
    std::vector<LeftOutScene> leftOut;
};

/// Sets ratioToBaseline of every timed point; points[baseline] is what they are held against.
void setRatios(std::vector<PointResult>& points, std::size_t baseline);

/// Sets isOnFront of every comparison, by median time and error.
void markFronts(SceneResult& scene);

}  // namespace nephrite::pareto
