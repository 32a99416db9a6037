// A session to which everything that can change does, at random, from frame to frame.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "changing_scenes.h"
#include "graph/random_ports.h"
#include "runtime/session.h"
#include "scratch_folder.h"

namespace nephrite::runtime::test {

/// Runs through sessions of random scenes and options, each of which changes its graph, size, camera and
/// parameters, and the time of its frames. What a session holds on the device is compared each time it comes
/// back to a graph.
class RandomChanges {
  public:
    RandomChanges(std::uint64_t seed, Validation validation);

    /// Makes some changes and starts a frame, now and then waits for it and reads pictures. Validation
    /// messages throw RunError. Throws std::runtime_error if a session holds other device memory than when it
    /// last began the same graph with the same options.
    void frame();
    /// The next frame begins another session.
    void endSession();

    /// How often each thing was done and each feature of the library was there.
    const std::map<std::string, std::uint64_t>& counts() const { return counts_; }

    /// The session's options and what has happened since it began its present graph, a line each.
    std::string story() const { return options_ + "\n" + story_; }

  private:
    void note(const std::string& change, bool isStart = false);
    void startSession();
    void changeGraph();
    void refuseGraph();
    void beginGraph(std::size_t graph);
    void expectKnownMemory(std::size_t graph);
    void countFeatures();
    void changeSomething();
    void changeSize();
    void changeSetting();
    void moveCamera();
    void renderFrame();
    void readPicture();
    std::uint32_t side() { return 16 + 8 * chance_.below(5); }

    graph::tests::Chance chance_;
    Validation validation_;
    ScratchFolder folder_;
    std::vector<ChangingScene> scenes_;
    std::optional<Session> session_;
    const ChangingScene* scene_ = nullptr;  ///< of the session
    std::size_t graph_ = 0;                 ///< of the scene's
    std::string options_;                   ///< of the session, and its scene
    std::string story_;
    std::map<std::string, SessionFigures> known_;
    std::map<std::string, std::uint64_t> counts_;
    double time_ = 0;
};

}  // namespace nephrite::runtime::test
