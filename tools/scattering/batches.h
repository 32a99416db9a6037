// Numbered pieces of work over threads. Which thread does which is left to chance and must not matter.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace nephrite::scattering {

/// How work is spread and watched.
struct WorkSettings {
    unsigned threads = 2;
    /// Asked after each piece, from one thread at a time, with the fraction done; false stops the work. May
    /// be empty.
    std::function<bool(double)> proceed;
};

/// Calls `work(i)` for each i below `count`, every thread with its own copy of `work`. False if it was
/// stopped.
template<class Work>
bool runBatches(std::size_t count, const WorkSettings& settings, const Work& work) {
    std::atomic<std::size_t> next{0};
    std::atomic<bool> stopped{false};
    std::mutex reporting;
    std::size_t done = 0;
    const auto runThread = [&] {
        Work own = work;
        for (std::size_t index = next++; index < count && !stopped; index = next++) {
            own(index);
            if (!settings.proceed) continue;
            const std::lock_guard lock(reporting);
            if (!settings.proceed(static_cast<double>(++done) / static_cast<double>(count))) stopped = true;
        }
    };
    {
        std::vector<std::jthread> helpers;
        for (unsigned i = 1; i < settings.threads; ++i) helpers.emplace_back(runThread);
        runThread();
    }
    return !stopped;
}

}  // namespace nephrite::scattering
