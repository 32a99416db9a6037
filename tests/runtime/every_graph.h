// Renders every graph with every scene of the tree under synchronization validation.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "runtime/session.h"

namespace nephrite::runtime::test {

inline std::vector<std::filesystem::path> jsonFiles(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

inline void expectFinite(const image::Image& image, const std::string& what) {
    for (const float value : image.pixels) ASSERT_TRUE(std::isfinite(value)) << what;
}

/// Two frames of each graph and scene at each size: no validation message, every value of the picture finite.
inline void renderEveryGraph(const std::vector<std::uint32_t>& sizes,
                             const std::vector<std::string>& settings = {}) {
    const std::filesystem::path graphs = std::filesystem::path(NEPHRITE_SOURCE_DIR) / "graphs";
    for (const std::filesystem::path& graph : jsonFiles(graphs)) {
        for (const std::filesystem::path& scene : jsonFiles(graphs / "scenes")) {
            for (const std::uint32_t size : sizes) {
                SessionOptions options;
                options.graph = graph;
                options.scene = scene;
                options.size = {size, size};
                options.validation = Validation::Sync;
                if (graph.stem() == "paper") options.settings = settings;
                const std::string what =
                    graph.stem().string() + " of " + scene.stem().string() + " at " + std::to_string(size);
                // A validation message makes the session throw.
                Session session(options);
                for (int frame = 0; frame < 2; ++frame)
                    ASSERT_NO_THROW(session.renderFrame(frame / 30.0)) << what;
                expectFinite(session.read("color"), what);
            }
        }
    }
}

}  // namespace nephrite::runtime::test
