// Reading a graph for a session.
#include "runtime/planning/graph_content.h"

#include <algorithm>

#include "runtime/resources/imports.h"

namespace nephrite::runtime {

GraphContent::GraphContent(GraphSource source, const DataFolders& folders,
                           const std::vector<std::filesystem::path>& passPaths,
                           const graph::LinkedGraph* before)
    : source_(std::move(source)),
      loaded_(loadGraph(source_.file, source_.settings, folders, passPaths, source_.text, source_.display)),
      importFiles_(std::make_shared<const std::vector<image::Image>>(readImports(graph().description))) {
    values = std::make_shared<graph::ParameterValues>(loaded_.graph->values);
    for (const std::string& dump : source_.dumps) dumps_.push_back(dumpReference(dump));
    if (before != nullptr) dropOutdatedChanges(*before);
    const std::vector<std::string> changes = std::exchange(source_.changes, {});
    applyChanges(changes);
}

void GraphContent::dropOutdatedChanges(const graph::LinkedGraph& before) {
    std::erase_if(source_.changes, [&](const std::string& change) {
        const graph::ParameterValue* then = graph::findValue(before, before.values, graph::targetOf(change));
        const graph::ParameterValue* now = graph::findValue(graph(), graph().values, graph::targetOf(change));
        return then != nullptr && now != nullptr && !(*then == *now);
    });
}

void GraphContent::addChange(const std::string& setting) {
    std::erase_if(source_.changes, [&](const std::string& earlier) {
        return graph::targetOf(earlier) == graph::targetOf(setting);
    });
    source_.changes.push_back(setting);
}

void GraphContent::applyChanges(const std::vector<std::string>& changes) {
    for (const std::string& change : changes) {
        if (std::find(source_.changes.begin(), source_.changes.end(), change) != source_.changes.end())
            continue;
        try {
            values = std::make_shared<graph::ParameterValues>(graph::applySetting(graph(), *values, change));
            addChange(change);
        } catch (const InputError&) {
            // It was made to a graph that had such a parameter or range; this one has not.
        }
    }
}

void GraphContent::upload(const gpu::Device& device, graph::InputReads reads, const GraphContent* before) {
    const std::vector<graph::GraphImport>& imports = graph().description.imports;
    imports_.clear();
    for (std::size_t i = 0; i < imports.size(); ++i) {
        auto image = before == nullptr ? nullptr : uploaded(i, *before);
        if (image == nullptr)
            image = std::make_shared<const gpu::Image>(
                uploadImport(device, imports[i], (*importFiles_)[i], reads));
        imports_.push_back(std::move(image));
    }
}

/// The image on the device that `before` made of the same texels; null if there is none.
std::shared_ptr<const gpu::Image> GraphContent::uploaded(std::size_t index,
                                                         const GraphContent& before) const {
    const graph::GraphImport& import = graph().description.imports[index];
    const image::Image& file = (*importFiles_)[index];
    for (std::size_t i = 0; i < before.imports_.size(); ++i) {
        const graph::GraphImport& known = before.graph().description.imports[i];
        if (known.name == import.name && known.format == import.format && (*before.importFiles_)[i] == file)
            return before.imports_[i];
    }
    return nullptr;
}

graph::CompileRequest GraphContent::request(graph::InputReads reads) const {
    graph::CompileRequest result;
    result.graph = loaded_.graph;
    result.dumps = dumps_;
    result.inputReads = reads;
    result.imports = importedImages(graph().description, *importFiles_, reads);
    result.parameters = values;
    return result;
}

std::vector<std::filesystem::path> GraphContent::files() const {
    std::vector<std::filesystem::path> files{source_.file};
    for (const graph::LinkedNode& node : graph().nodes)
        if (node.type != nullptr && !node.type->manifest.empty()) files.push_back(node.type->manifest);
    for (const graph::GraphImport& import : graph().description.imports) files.push_back(import.image);
    return files;
}

}  // namespace nephrite::runtime
