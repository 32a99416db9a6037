// Every graph with every scene of the tree at both sizes under synchronization validation: no message, finite
// pictures.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "runtime/session.h"

namespace nephrite::runtime {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> jsonFiles(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

void expectFinite(const image::Image& image, const std::string& what) {
    for (const float value : image.pixels) ASSERT_TRUE(std::isfinite(value)) << what;
}

TEST(EveryGraph, EverySceneAtBothSizesIsCleanAndFinite) {
    const fs::path graphs = fs::path(NEPHRITE_SOURCE_DIR) / "graphs";
    for (const fs::path& graph : jsonFiles(graphs)) {
        for (const fs::path& scene : jsonFiles(graphs / "scenes")) {
            for (const std::uint32_t size : {512U, 1024U}) {
                SessionOptions options;
                options.graph = graph;
                options.scene = scene;
                options.size = {size, size};
                options.validation = Validation::Sync;
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

}  // namespace
}  // namespace nephrite::runtime
