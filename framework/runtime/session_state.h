// What a session consists of. Its member functions stand by subject: session.cpp, session_changes.cpp,
// session_drafts.cpp, session_images.cpp.
#pragma once

#include "runtime/draft_state.h"
#include "runtime/rendering.h"
#include "runtime/session_device.h"
#include "runtime/shown.h"

namespace nephrite::runtime {

/// In the order of construction; what comes later uses what comes before.
struct Session::State {
    explicit State(const SessionOptions& sessionOptions);

    PlanningContext planning() const { return {hardware.device, hardware.reads, options}; }
    Plans plans() { return makePlans(planning(), shown.content, shown.scene->facts(), programs); }
    /// Plans anew, with the graph, the scene, the values and the size as they are; if that fails, what is
    /// rendered stays as it was.
    void rebuild() { rendering.carryOut(plans(), shown, programs); }

    void set(const std::string& setting);
    /// Hands the present values to what was made with those `before`. False if that has to be made anew: the
    /// values decide the plan, and it comes out another, or they are compiled into shaders.
    bool servesValues(const graph::ParameterValues& before);

    std::unique_ptr<Draft::State> draft(DraftRequest request) const;
    bool adopt(Draft::State& draft);

    /// The output or dump of that name. Throws RunError if there is none.
    const graph::RequestedOutput& requested(const std::string& name) const;
    /// As the last frame left it. No frame may be under way.
    image::Image read(const graph::RequestedOutput& output) const;

    SessionOptions options;  ///< as it began, but for the size; what it shows now is in `shown`
    DataFolders folders;
    SessionDevice hardware;
    Shown shown;
    ProgramCache programs;
    Rendering rendering{options};
    Diagnostics diagnostics;
    std::uint64_t graphs = 0;  ///< counts those shown, and scenes

  private:
    State(const SessionOptions& sessionOptions, const DataFolders& dataFolders);
    State(const SessionOptions& sessionOptions, const DataFolders& dataFolders, Shown read);
};

}  // namespace nephrite::runtime
