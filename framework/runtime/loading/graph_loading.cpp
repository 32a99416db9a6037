// Loading of graphs and scenes by file name.
#include "runtime/loading/graph_loading.h"

#include "gpu/device.h"

namespace nephrite::runtime {

std::unique_ptr<graph::PassLibrary> loadPassTypes(const DataFolders& folders,
                                                  const std::vector<std::filesystem::path>& passPaths) {
    for (const std::filesystem::path& folder : passPaths) {
        std::error_code ignored;
        if (!std::filesystem::is_directory(folder, ignored))
            throw InputError({folder.string()}, "cannot look for pass manifests here: it is not a folder");
    }
    std::vector<std::filesystem::path> all{folders.passes};
    all.insert(all.end(), passPaths.begin(), passPaths.end());
    return std::make_unique<graph::PassLibrary>(all, folders.shaders);
}

LoadedGraph loadGraph(const std::filesystem::path& file, const std::vector<std::string>& settings,
                      const DataFolders& folders, const std::vector<std::filesystem::path>& passPaths,
                      const std::optional<std::string>& text, const std::optional<graph::Display>& display) {
    LoadedGraph loaded;
    loaded.passTypes = loadPassTypes(folders, passPaths);
    graph::GraphDescription description =
        graph::readGraph(text ? json::parse(*text, file.string()) : json::parseFile(file));
    for (const std::string& setting : settings) graph::applySetting(description, setting);
    if (display) graph::addDisplay(description, *display, *loaded.passTypes);
    loaded.graph = graph::link(std::move(description), *loaded.passTypes);
    return loaded;
}

scene::Scene loadScene(const std::filesystem::path& file, double time, const DataFolders& folders) {
    scene::SceneOptions options;
    options.time = time;
    options.materialFolder = folders.materials;
    options.modelFolder = folders.models;
    return scene::Scene::load(file.empty() ? folders.defaultScene : file, options);
}

graph::InputReads inputReadsOn(const gpu::Device& device) {
    const bool storage = device.isCpu() && device.features().storageExtendedFormats;
    return storage ? graph::InputReads::StorageImage : graph::InputReads::SampledImage;
}

graph::SceneFacts sceneFacts(const scene::Facts& facts) {
    graph::SceneFacts result;
    result.translucentMaterials = facts.translucentMaterials;
    result.opaqueMaterials = facts.opaqueMaterials;
    result.pointLights = facts.pointLights;
    result.environment = facts.environment;
    result.maxLayers = facts.maxLayers;
    result.layerTextures = facts.layerTextures;
    result.animated = facts.animated;
    result.objects = facts.objects;
    result.lightViews = facts.lightViews;
    return result;
}

graph::PortReference dumpReference(const std::string& text) {
    Diagnostics diagnostics;
    auto reference = graph::readPortReference(text, {"--dump", 0, 0}, diagnostics);
    diagnostics.throwIfErrors();
    return *reference;
}

}  // namespace nephrite::runtime
