// Renders a part of a picture: rounds of samples, each shared out among threads by tiles, with the mean and
// the standard error of every value. What is done can be saved and continued.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "image/image.h"
#include "scattering/statistics.h"
#include "truth/estimator.h"
#include "truth/tiles.h"

namespace nephrite::truth {

/// What a rendering asks its owner while it runs, from the thread that runs it.
struct Watcher {
    std::function<bool()> stop = [] { return false; };
    std::function<void(double)> progress = [](double) {};                     ///< done so far, 0 to 1
    std::function<void(const std::string&)> say = [](const std::string&) {};  ///< a line for the reader
};

class Rendering {
  public:
    /// `samples` of each pixel of the part. World and estimator must outlive it.
    Rendering(const World& world, const Camera& camera, Estimator& estimator, const Part& part,
              std::uint32_t samples);

    /// Does what is left on `threads` threads, until the watcher says stop. What is not done by then of a
    /// tile's round is dropped.
    void run(unsigned threads, const Watcher& watcher);
    bool isFinished() const;

    /// Channels of the estimator, and A: 1 where the pixel's ray meets a surface. Pixels of other parts are
    /// 0.
    image::Image picture() const;
    /// The standard error of each value of picture(); A is 0.
    image::Image standardErrors() const;

    /// All that is done, as bytes of this machine.
    std::string save() const;
    /// Continues from saved bytes. False, and nothing happens, if they cannot be what a rendering of this
    /// size saved: too many samples, or values that are not finite.
    bool restore(std::string_view saved);

  private:
    struct Round;
    void renderRound(unsigned threads, const Watcher& watcher, std::uint32_t first, std::uint32_t last);
    /// Samples first to last - 1 of a tile into `statistics`; false if told to stop.
    bool renderTile(std::size_t tile, std::uint32_t first, std::uint32_t last, Round& round);
    bool canHaveDone(std::uint32_t samples) const;
    image::Image assemble(bool errors) const;
    double fractionDone() const;

    const World& world_;
    const Camera& camera_;
    Estimator& estimator_;
    std::uint32_t samples_;
    std::vector<std::string> channels_;
    std::vector<Tile> tiles_;
    std::vector<std::uint32_t> samplesDone_;                              ///< by tile
    std::vector<std::vector<scattering::RunningStatistics>> statistics_;  ///< by tile: pixel, channel
};

}  // namespace nephrite::truth
