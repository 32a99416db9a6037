// The graph that a session renders: what of it stays the same however often it is planned.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runtime/frame_resources.h"
#include "runtime/graph_loading.h"
#include "runtime/session.h"

namespace nephrite::runtime {

class GraphContent {
  public:
    /// Reads and links. Needs no device yet, so that faults of the files come first. Throws InputError.
    GraphContent(const GraphSource& source, const DataFolders& folders,
                 const std::vector<std::filesystem::path>& passPaths);

    /// Brings the images it imports to the device, which must outlive it; `reads` is how shaders read them.
    /// Throws RunError.
    void upload(const gpu::Device& device, graph::InputReads reads);

    /// What it asks of the compiler; size, scene, device and ways of planning are the session's.
    graph::CompileRequest request(graph::InputReads reads) const;

    const graph::LinkedGraph& graph() const { return *loaded_.graph; }
    const ImportedImages& imports() const { return imports_; }

    std::shared_ptr<const graph::ParameterValues> values;  ///< of its parameters, as they are now

  private:
    LoadedGraph loaded_;
    std::vector<graph::PortReference> dumps_;
    std::vector<image::Image> importFiles_;
    ImportedImages imports_;
};

}  // namespace nephrite::runtime
