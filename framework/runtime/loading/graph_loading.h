// From file names to a linked graph and a loaded scene: what a session and the `plan` verb both start from.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graph/compile.h"
#include "graph/display.h"
#include "runtime/loading/data_folders.h"
#include "scene/scene.h"

namespace nephrite::gpu {
class Device;
}

namespace nephrite::runtime {

/// A graph with the pass types it points into. Copies share both.
struct LoadedGraph {
    std::shared_ptr<const graph::PassLibrary> passTypes;
    std::shared_ptr<const graph::LinkedGraph> graph;
};

/// The project's pass types and those of `passPaths`, later folders first. Throws InputError if one is no
/// folder.
std::unique_ptr<graph::PassLibrary> loadPassTypes(const DataFolders& folders,
                                                  const std::vector<std::filesystem::path>& passPaths);

/// Reads a graph file, or `text` in its stead, applies `--set` settings, adds what `display` asks for and
/// links it. Throws InputError.
LoadedGraph loadGraph(const std::filesystem::path& file, const std::vector<std::string>& settings,
                      const DataFolders& folders, const std::vector<std::filesystem::path>& passPaths,
                      const std::optional<std::string>& text = std::nullopt,
                      const std::optional<graph::Display>& display = std::nullopt);

/// Reads a scene file, whose facts are those of `time` seconds; an empty path is the default scene. Throws
/// InputError.
scene::Scene loadScene(const std::filesystem::path& file, double time, const DataFolders& folders);

/// How shaders read images fastest on a device: storage images on a CPU, sampled images on a GPU.
graph::InputReads inputReadsOn(const gpu::Device& device);

/// The scene's facts as the compiler wants them.
graph::SceneFacts sceneFacts(const scene::Facts& facts);

/// `NODE.PORT` from a command line. Throws InputError.
graph::PortReference dumpReference(const std::string& text);

}  // namespace nephrite::runtime
