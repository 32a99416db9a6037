// Threads, tiles and rounds.
#include "truth/rendering.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>

namespace nephrite::truth {
namespace {

/// What is kept of a value's statistics; the count is the tile's.
struct SavedValue {
    double mean;
    double squaredDeviations;
};

template<class Value>
void append(std::string& bytes, const Value& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(Value));
}

template<class Value>
Value take(std::string_view& bytes) {
    Value value;
    std::memcpy(&value, bytes.data(), sizeof(Value));
    bytes.remove_prefix(sizeof(Value));
    return value;
}

/// The surface that a pixel shows, if its ray meets one between the near and the far plane.
std::optional<SurfacePoint> seenBy(const World& world, const CameraRay& ray) {
    return world.geometry().trace(ray.ray, ray.near, ray.far);
}

}  // namespace

/// A round under way, shared by its threads.
struct Rendering::Round {
    std::atomic<std::size_t> next{0};
    std::atomic<std::size_t> finishedThreads{0};
    std::atomic<std::uint64_t> pixelSamples{0};
    std::atomic<bool> stop{false};
    std::mutex mutex;
    std::exception_ptr failure;
};

Rendering::Rendering(const World& world, const Camera& camera, Estimator& estimator, const Part& part,
                     std::uint32_t samples)
    : world_(world),
      camera_(camera),
      estimator_(estimator),
      samples_(samples),
      channels_(estimator.channels()),
      tiles_(tilesOf(camera.width(), camera.height(), part)),
      samplesDone_(tiles_.size(), 0) {
    for (const Tile& tile : tiles_) statistics_.emplace_back(tile.pixels() * channels_.size());
}

bool Rendering::isFinished() const {
    return std::all_of(samplesDone_.begin(), samplesDone_.end(),
                       [&](std::uint32_t done) { return done == samples_; });
}

double Rendering::fractionDone() const {
    double done = 0;
    for (const std::uint32_t samples : samplesDone_) done += samples;
    return tiles_.empty() ? 1 : done / (static_cast<double>(samples_) * static_cast<double>(tiles_.size()));
}

void Rendering::run(unsigned threads, const Watcher& watcher) {
    while (!isFinished() && !watcher.stop()) {
        const std::uint32_t first = *std::min_element(samplesDone_.begin(), samplesDone_.end());
        const std::uint32_t each = estimator_.samplesPerRound();
        const std::uint32_t last = std::min(samples_, first - first % each + each);
        estimator_.beginRound(first, last, threads);
        renderRound(threads, watcher, first, last);
    }
}

void Rendering::renderRound(unsigned threads, const Watcher& watcher, std::uint32_t first,
                            std::uint32_t last) {
    Round round;
    const auto work = [&] {
        try {
            for (std::size_t tile = round.next++; tile < tiles_.size(); tile = round.next++)
                if (samplesDone_[tile] == first && !renderTile(tile, first, last, round)) break;
        } catch (...) {
            const std::lock_guard lock(round.mutex);
            round.failure = std::current_exception();
            round.stop = true;
        }
        ++round.finishedThreads;
    };
    const double before = fractionDone();
    double all = 0;
    for (const Tile& tile : tiles_) all += static_cast<double>(tile.pixels()) * samples_;
    std::vector<std::thread> workers;
    for (unsigned i = 0; i < threads; ++i) workers.emplace_back(work);
    while (round.finishedThreads < threads) {
        if (watcher.stop()) round.stop = true;
        watcher.progress(before + static_cast<double>(round.pixelSamples) / all);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    for (std::thread& worker : workers) worker.join();
    if (round.failure) std::rethrow_exception(round.failure);
}

bool Rendering::renderTile(std::size_t index, std::uint32_t first, std::uint32_t last, Round& round) {
    const Tile& tile = tiles_[index];
    std::vector<scattering::RunningStatistics> statistics = statistics_[index];
    std::vector<double> values(channels_.size());
    std::size_t place = 0;
    for (std::uint32_t y = tile.y0; y < tile.y1; ++y) {
        for (std::uint32_t x = tile.x0; x < tile.x1; ++x, place += values.size()) {
            if (round.stop) return false;
            const CameraRay ray = camera_.through(x, y);
            const auto seen = seenBy(world_, ray);
            const bool scatters = seen && world_.materialOf(seen->object).translucent();
            for (std::uint32_t sample = first; sample < last; ++sample) {
                std::fill(values.begin(), values.end(), 0.0);
                if (scatters) estimator_.sample(ray, *seen, y * camera_.width() + x, sample, values);
                for (std::size_t c = 0; c < values.size(); ++c) statistics[place + c].add(values[c]);
            }
            round.pixelSamples += last - first;
        }
    }
    statistics_[index] = std::move(statistics);
    samplesDone_[index] = last;
    return true;
}

image::Image Rendering::assemble(bool errors) const {
    image::Image image;
    image.width = camera_.width();
    image.height = camera_.height();
    image.channels = channels_;
    image.channels.insert(image.channels.begin() + 3, "A");
    const std::size_t count = image.channels.size();
    image.pixels.resize(std::size_t{image.width} * image.height * count);
    for (std::size_t index = 0; index < tiles_.size(); ++index) {
        const Tile& tile = tiles_[index];
        auto value = statistics_[index].begin();
        for (std::uint32_t y = tile.y0; y < tile.y1; ++y) {
            for (std::uint32_t x = tile.x0; x < tile.x1; ++x) {
                float* pixel = &image.pixels[(std::size_t{y} * image.width + x) * count];
                for (std::size_t c = 0; c < count; ++c) {
                    if (image.channels[c] == "A")
                        pixel[c] = !errors && seenBy(world_, camera_.through(x, y)) ? 1.0F : 0.0F;
                    else
                        pixel[c] = static_cast<float>(errors ? value->standardError() : value->mean()),
                        ++value;
                }
            }
        }
    }
    return image;
}

image::Image Rendering::picture() const {
    return assemble(false);
}
image::Image Rendering::standardErrors() const {
    return assemble(true);
}

std::string Rendering::save() const {
    std::string bytes;
    for (std::size_t tile = 0; tile < tiles_.size(); ++tile) {
        append(bytes, samplesDone_[tile]);
        for (const scattering::RunningStatistics& value : statistics_[tile])
            append(bytes, SavedValue{value.mean(), value.squaredDeviations()});
    }
    return bytes;
}

/// Whole rounds, or all.
bool Rendering::canHaveDone(std::uint32_t samples) const {
    return samples == samples_ || (samples < samples_ && samples % estimator_.samplesPerRound() == 0);
}

bool Rendering::restore(std::string_view saved) {
    std::size_t expected = 0;
    for (const auto& values : statistics_)
        expected += sizeof(std::uint32_t) + values.size() * sizeof(SavedValue);
    if (saved.size() != expected) return false;
    std::vector<std::uint32_t> samplesDone;
    auto statistics = statistics_;
    for (auto& tile : statistics) {
        const auto done = take<std::uint32_t>(saved);
        if (!canHaveDone(done)) return false;
        samplesDone.push_back(done);
        for (scattering::RunningStatistics& value : tile) {
            const auto kept = take<SavedValue>(saved);
            if (!std::isfinite(kept.mean) || !std::isfinite(kept.squaredDeviations) ||
                kept.squaredDeviations < 0)
                return false;
            value = {done, kept.mean, kept.squaredDeviations};
        }
    }
    samplesDone_ = std::move(samplesDone);
    statistics_ = std::move(statistics);
    return true;
}

}  // namespace nephrite::truth
