// Reading a graph for a session.
#include "runtime/graph_content.h"

#include "runtime/imports.h"

namespace nephrite::runtime {
namespace {

LoadedGraph load(const GraphSource& source, const DataFolders& folders,
                 const std::vector<std::filesystem::path>& passPaths) {
    LoadedGraph loaded;
    loaded.passTypes = loadPassTypes(folders, passPaths);
    graph::GraphDescription description =
        source.text ? graph::readGraph(json::parse(*source.text, source.file.string()))
                    : graph::readGraph(source.file);
    for (const std::string& setting : source.settings) graph::applySetting(description, setting);
    if (source.display) graph::addDisplay(description, *source.display, *loaded.passTypes);
    loaded.graph = graph::link(std::move(description), *loaded.passTypes);
    return loaded;
}

}  // namespace

GraphContent::GraphContent(const GraphSource& source, const DataFolders& folders,
                           const std::vector<std::filesystem::path>& passPaths)
    : loaded_(load(source, folders, passPaths)), importFiles_(readImports(loaded_.graph->description)) {
    values = std::make_shared<graph::ParameterValues>(loaded_.graph->values);
    for (const std::string& dump : source.dumps) dumps_.push_back(dumpReference(dump));
}

void GraphContent::upload(const gpu::Device& device, graph::InputReads reads) {
    imports_ = uploadImports(device, loaded_.graph->description, importFiles_, reads);
}

graph::CompileRequest GraphContent::request(graph::InputReads reads) const {
    graph::CompileRequest result;
    result.graph = loaded_.graph;
    result.dumps = dumps_;
    result.inputReads = reads;
    result.imports = importedImages(loaded_.graph->description, importFiles_, reads);
    result.parameters = values;
    return result;
}

}  // namespace nephrite::runtime
