// Reading a graph for a session.
#include "runtime/graph_content.h"

#include "runtime/imports.h"

namespace nephrite::runtime {

GraphContent::GraphContent(const GraphSource& source, const DataFolders& folders,
                           const std::vector<std::filesystem::path>& passPaths)
    : loaded_(loadGraph(source.file, source.settings, folders, passPaths, source.text, source.display)),
      importFiles_(readImports(loaded_.graph->description)) {
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
