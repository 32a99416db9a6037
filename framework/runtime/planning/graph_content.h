// The graph that a session renders: what of it stays the same however often it is planned.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "image/image.h"
#include "runtime/loading/graph_loading.h"
#include "runtime/planning/session_options.h"
#include "runtime/resources/frame_resources.h"

namespace nephrite::runtime {

/// Copies are cheap: they share what was read and uploaded.
class GraphContent {
  public:
    /// Reads and links. Needs no device yet, so that faults of the files come first. `before`, if there is
    /// one, is the graph as it was read when source.changes were made. Throws InputError.
    GraphContent(GraphSource source, const DataFolders& folders,
                 const std::vector<std::filesystem::path>& passPaths,
                 const graph::LinkedGraph* before = nullptr);

    /// Brings the images it imports to the device, which must outlive it; `reads` is how shaders read them.
    /// Images that `before` has just so are shared with it. Throws RunError.
    void upload(const gpu::Device& device, graph::InputReads reads, const GraphContent* before = nullptr);

    /// What it asks of the compiler; size, scene, device and ways of planning are the session's.
    graph::CompileRequest request(graph::InputReads reads) const;

    const GraphSource& source() const { return source_; }
    const graph::LinkedGraph& graph() const { return *loaded_.graph; }
    const ImportedImages& imports() const { return imports_; }
    /// The graph's file, the manifests of its passes, the images it imports.
    std::vector<std::filesystem::path> files() const;

    /// Notes that a setting was applied to `values`.
    void addChange(const std::string& setting);
    /// Applies and notes changes that fit and are not there yet; others are left out.
    void applyChanges(const std::vector<std::string>& changes);

    std::shared_ptr<const graph::ParameterValues> values;  ///< of its parameters, as they are now

  private:
    void dropOutdatedChanges(const graph::LinkedGraph& before);
    std::shared_ptr<const gpu::Image> uploaded(std::size_t index, const GraphContent& before) const;

    GraphSource source_;
    LoadedGraph loaded_;
    std::vector<graph::PortReference> dumps_;
    std::shared_ptr<const std::vector<image::Image>> importFiles_;
    ImportedImages imports_;
};

}  // namespace nephrite::runtime
