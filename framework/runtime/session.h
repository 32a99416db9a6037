// A graph, a scene and a device together: renders frames and hands out their images.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graph/plan.h"
#include "image/image.h"
#include "runtime/frame/timings.h"
#include "runtime/planning/session_options.h"
#include "text/diagnostics.h"

namespace nephrite::gpu {
class Device;
class Image;
}  // namespace nephrite::gpu

namespace nephrite::scene {
class Scene;
struct CameraDescription;
}  // namespace nephrite::scene

namespace nephrite::runtime {

class Draft;
struct DraftRequest;

/// What a session holds and has done.
struct SessionFigures {
    std::uint64_t deviceBytes = 0;  ///< of device memory
    std::size_t deviceAllocations = 0;
    std::uint64_t plans = 0;      ///< made so far
    std::uint64_t pipelines = 0;  ///< built so far
};

/// A requested image where a frame leaves it.
struct ExportedImage {
    const gpu::Image* image = nullptr;  ///< valid until the next plan is made
    graph::Subresources part;           ///< its levels and layers that were requested
};

/// Everything needed to render one graph of one scene at one size.
class Session {
  public:
    /// Reads, links, compiles, builds pipelines, allocates. Throws InputError or RunError.
    explicit Session(const SessionOptions& options);
    ~Session();
    Session(Session&&) noexcept;

    /// Renders the scene at `time` seconds and waits for it. Throws RunError (device lost, validation
    /// message).
    FrameTimes renderFrame(double time);
    /// The same without waiting: up to SessionOptions::framesInFlight frames are under way at once.
    void startFrame(double time);
    void waitForFrames();

    /// Changes a parameter, `NODE.PARAM=JSON` or `PARAM=JSON`, from the next frame on. The plan is made anew
    /// only if the parameter decides it or is compiled into a shader. Throws InputError, and then nothing has
    /// changed.
    void set(const std::string& setting);
    /// Another output size from the next frame on. Kept results and history start anew. Throws as the
    /// constructor.
    void resize(graph::Extent size);
    /// Another graph, or the same file read anew, from the next frame on; its parameters start from the file
    /// and `settings`. History of ports that keep their name and shape goes on, and so do kept results of
    /// passes that stay the same. Throws as the constructor, and then nothing has changed.
    void setGraph(const GraphSource& source);
    /// Another scene, or the same file read anew; empty: the default one. Kept results of passes that read
    /// nothing that differs go on. Throws as the constructor, and then nothing has changed.
    void setScene(const std::filesystem::path& scene);
    /// Another camera than the scene's from the next frame on, until a scene with another one is set.
    void setCamera(const scene::CameraDescription& camera);

    /// Begins a graph and a scene beside those that are shown. Cheap; Draft::build does the work.
    Draft draft(DraftRequest request) const;
    /// Shows a draft that was built, from the next frame on; values set since it was begun are set in it too.
    /// False, and nothing has changed, if another graph or scene was set since. Throws as the constructor,
    /// and then nothing has changed.
    bool adopt(Draft& draft);
    /// What is shown: to read it anew.
    DraftRequest shown() const;
    /// Every file that what is shown was made from, absolute, also those that are not there but would decide.
    std::vector<std::filesystem::path> files() const;
    /// When the reading of these files began.
    std::filesystem::file_time_type readAt() const;

    /// An output ("color") or a dump ("gbuffer.position") of the last frame. Several layers or mips become
    /// channels "layer1.R", "mip2.R"; layer 0 of level 0 is plain "R".
    image::Image read(const std::string& name);
    /// The same of one level and layer alone; its channels are R, G, B, A. Throws RunError if there is no
    /// such.
    image::Image read(const std::string& name, std::uint32_t mip, std::uint32_t layer);
    /// The same output on the device, in VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL after each frame and until the
    /// next one. What reads it needs a barrier behind the frame, and to be done before the next plan is made.
    /// Nothing if nothing computes it, if it is a buffer, or if something keeps it in another layout.
    std::optional<ExportedImage> exported(const std::string& name) const;

    const graph::Plan& plan() const;  ///< of the next frame; points to pass types of the session: a copy must
                                      ///< not outlive it
    const graph::ParameterValues& parameters() const;  ///< as they are now
    const Diagnostics& diagnostics() const;            ///< warnings so far
    const scene::Scene& scene() const;
    const gpu::Device& device() const;
    const std::string& deviceName() const;
    const std::string& driverName() const;
    SessionFigures figures() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace nephrite::runtime
