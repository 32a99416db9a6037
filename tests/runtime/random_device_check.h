// Random graphs on the device: however a plan orders them and whatever shares memory, they give the same
// bits.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "graph/pass_type.h"
#include "runtime/random_device_graphs.h"
#include "runtime/session.h"
#include "scratch_folder.h"

namespace nephrite::runtime::test {

/// What was seen in the plans of many graphs.
struct RandomDeviceFigures {
    std::size_t graphs = 0;
    std::size_t passes = 0;
    std::size_t barriers = 0;
    std::size_t images = 0;         ///< compared
    std::size_t sharingGraphs = 0;  ///< in which something lies on bytes that held something else
    std::size_t histories = 0;
    std::size_t tiled = 0;            ///< passes over lists of tiles
    std::set<std::string> passTypes;  ///< that ran
};

class RandomDeviceCheck {
  public:
    RandomDeviceCheck();

    /// Renders three frames of a random graph, validated, as planned and again in plain order without shared
    /// memory and with a full barrier after every pass; compares everything that can be read of the last.
    testing::AssertionResult check(std::uint64_t seed);

    /// The graph of a seed as a file in the folder, and how it is rendered.
    SessionOptions optionsFor(std::uint64_t seed, const RandomDeviceGraph& graph) const;
    RandomDeviceGraph graphOf(std::uint64_t seed) const { return randomDeviceGraph(seed, *library_); }
    const RandomDeviceFigures& figures() const { return figures_; }

  private:
    void compare(const SessionOptions& options, const RandomDeviceGraph& graph, bool flying);
    void count(const graph::Plan& plan);

    ScratchFolder folder_;
    std::unique_ptr<graph::PassLibrary> library_;
    RandomDeviceFigures figures_;
};

/// Checks the seeds first to first + count - 1, and one that nobody has seen before, which is printed.
void checkRandomDeviceGraphs(std::uint64_t first, std::uint32_t count);

}  // namespace nephrite::runtime::test
