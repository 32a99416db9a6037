// Passes and graphs made up by a test, rendered under synchronization validation.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "runtime/session.h"
#include "scratch_folder.h"

namespace nephrite::runtime::test {

/// One channel of one pixel of a requested image.
inline float valueAt(Session& session, const std::string& name, std::uint32_t x, std::uint32_t y,
                     std::uint32_t channel = 0) {
    return session.read(name).at(x, y, channel);
}

class WithPasses : public testing::Test {
  protected:
    /// A pass type NAME of `kind`: `ports` are the manifest's other members, `shader` is its GLSL.
    void addPass(const std::string& name, const std::string& kind, const std::string& ports,
                 const std::string& shader) const {
        folder_.write("passes/" + name + ".json",
                      "{\"kind\": \"" + kind + "\", \"shader\": \"" + name + ".glsl\", " + ports + "}");
        folder_.write("passes/" + name + ".glsl", shader);
    }

    /// A graph of these members ("nodes": ..., "outputs": ...) of 16 x 16 pixels, validated, with all its
    /// passes run in every frame.
    SessionOptions graph(const std::string& members) const {
        SessionOptions options;
        options.graph = folder_.write("graph.json", "{\"name\": \"made up\", " + members + "}");
        options.passPaths = {folder_.path() / "passes"};
        options.size = {16, 16};
        options.validation = Validation::Sync;
        return options;
    }

    /// Counts its frames: one more than a frame ago. `step` is compiled into the shader.
    void addCounter() const {
        addPass("counter", "pixel",
                R"("inputs": {"before": {}},
                   "outputs": {"color": {"format": "r32f", "neutral": [10, 0, 0, 0]}},
                   "parameters": {"step": {"type": "float", "default": 1, "specialize": true},
                                  "bonus": {"type": "float", "default": 0}})",
                "void pixel(ivec2 p) { store(color, p, load(before, p) + params.step + params.bonus); }");
    }

    ScratchFolder folder_;
};

/// The passes that ran in a frame, by name, in order.
inline std::vector<std::string> ranIn(const FrameTimes& times, const Session& session) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < times.passes.size(); ++i)
        if (times.passes[i].ran) names.push_back(session.plan().nameOf(session.plan().passes[i]));
    return names;
}

}  // namespace nephrite::runtime::test
