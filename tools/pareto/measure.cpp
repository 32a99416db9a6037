// Sessions, side by side.
#include "pareto/measure.h"

#include <fmt/format.h>

#include "pareto/schedule.h"
#include "runtime/session.h"

namespace nephrite::pareto {
namespace {

using runtime::FrameTimes;
using runtime::Session;

constexpr double stillTime = 0;

runtime::SessionOptions optionsOf(const Point& point, const std::filesystem::path& scene,
                                  const FrameSettings& settings) {
    runtime::SessionOptions options;
    options.graph = point.method->graph;
    options.scene = scene;
    options.size = settings.size;
    options.settings = point.settingTexts();
    options.device = settings.device;
    options.skip = point.method->skip;
    return options;
}

/// The session of a point; faults of its graph come with the suite's line.
Session makeSession(const Point& point, const runtime::SessionOptions& options) {
    try {
        return Session(options);
    } catch (const InputError& error) {
        std::vector<Diagnostic> faults = error.faults();
        faults.push_back({point.method->where, fmt::format("the method {} cannot render {}",
                                                           inQuotes(point.name), options.scene.string())});
        throw InputError(std::move(faults));
    }
}

/// Points with a time, each with a session.
class Rounds {
  public:
    Rounds(const std::vector<Point>& points, const std::filesystem::path& scene,
           const FrameSettings& settings, bool profile) {
        for (std::uint32_t i = 0; i < points.size(); ++i) {
            if (!points[i].method->isTimed()) continue;
            runtime::SessionOptions options = optionsOf(points[i], scene, settings);
            options.profile = profile;
            points_.push_back(i);
            sessions_.push_back(makeSession(points[i], options));
        }
        times_.resize(sessions_.size());
    }

    /// `warmup` rounds and then `frames` that are kept; progress is shown from `begin` to `end`.
    void run(const FrameSettings& settings, const Progress& progress, const std::string& what, double begin,
             double end) {
        const auto count = static_cast<std::uint32_t>(sessions_.size());
        const std::uint32_t rounds = settings.warmup + settings.frames;
        for (std::uint32_t round = 0; round < rounds; ++round) {
            const bool counts = round >= settings.warmup;
            std::vector<std::uint32_t> order = roundOrder(count, round);
            for (std::uint32_t& place : order) {
                if (progress.stop()) throw RunError("interrupted; references are kept, times start anew");
                const FrameTimes times = sessions_[place].renderFrame(stillTime);
                if (counts) times_[place].push_back(times);
                place = points_[place];
            }
            if (counts) order_.push_back(std::move(order));
            progress.show(what, begin + (end - begin) * (round + 1) / rounds);
        }
    }

    const std::vector<std::uint32_t>& points() const { return points_; }
    const Session& session(std::size_t i) const { return sessions_[i]; }
    const std::vector<FrameTimes>& times(std::size_t i) const { return times_[i]; }
    const std::vector<std::vector<std::uint32_t>>& order() const { return order_; }

  private:
    std::vector<std::uint32_t> points_;  ///< of each session
    std::vector<Session> sessions_;
    std::vector<std::vector<FrameTimes>> times_;  ///< of each session, by round
    std::vector<std::vector<std::uint32_t>> order_;
};

}  // namespace

std::map<std::string, image::Image> renderPictures(const Point& point, const std::filesystem::path& scene,
                                                   const FrameSettings& settings) {
    runtime::SessionOptions options = optionsOf(point, scene, settings);
    for (const ComparedPort& compared : point.method->against)
        if (compared.port.find('.') != std::string::npos) options.dumps.push_back(compared.port);
    Session session = makeSession(point, options);
    session.renderFrame(stillTime);
    std::map<std::string, image::Image> pictures;
    for (const ComparedPort& compared : point.method->against)
        pictures.emplace(compared.port, session.read(compared.port));
    return pictures;
}

SceneTimes measureTimes(const std::vector<Point>& points, const std::filesystem::path& scene,
                        const FrameSettings& settings, const Progress& progress) {
    const std::string what = fmt::format("frames of {}", scene.stem().string());
    SceneTimes result;
    result.wallMs.resize(points.size());
    result.passes.resize(points.size());
    {
        Rounds frames(points, scene, settings, false);
        frames.run(settings, progress, what, 0, 0.5);
        for (std::size_t i = 0; i < frames.points().size(); ++i) {
            for (const FrameTimes& times : frames.times(i))
                result.wallMs[frames.points()[i]].push_back(times.wallMs);
            result.device = frames.session(i).deviceName();
            result.driver = frames.session(i).driverName();
        }
        result.rounds = frames.order();
    }
    Rounds profiled(points, scene, settings, true);
    profiled.run(settings, progress, what, 0.5, 1);
    for (std::size_t i = 0; i < profiled.points().size(); ++i)
        result.passes[profiled.points()[i]] = passTimes(profiled.session(i).plan(), profiled.times(i));
    return result;
}

}  // namespace nephrite::pareto
