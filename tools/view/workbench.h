// What is worked on in a window, without the window: a session, the graph's text, a camera, time, and what is
// looked at. Every change takes effect from the next frame on.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "document/live_graph.h"
#include "image/inspect.h"
#include "runtime/reload/live_reload.h"
#include "runtime/session.h"
#include "view/orbit_camera.h"
#include "view/pass_times.h"
#include "view/picture_choice.h"

namespace nephrite::view {

class Workbench {
  public:
    /// `options.settings` become edits that are not saved yet. `onSaved` is called from another thread when
    /// takeSaved() has something to do. Throws as Session.
    Workbench(runtime::SessionOptions options, std::function<void()> onSaved);

    // Changes throw InputError or RunError, and then nothing has changed: an edit that the session cannot
    // show is not made.
    void set(const std::string& target, const std::string& json, document::Gesture gesture);
    void reset(const std::string& target);
    void switchNode(const std::string& node, bool on);
    void swapPass(const std::string& node, const std::string& passType);
    void undo();
    void redo();
    void save();

    /// Brings what others have saved to the session and to the document, where edits that are not saved stay.
    /// What came of it; nothing if nothing was saved. Throws RunError if the device was lost.
    std::optional<runtime::Reload> takeSaved();

    /// What became of edits that met changes of others since the last call: warnings, a line each.
    std::vector<std::string> takeNotes() { return std::exchange(notes_, {}); }

    /// Looks at another port, or at the same otherwise. Another port is seen from its first level and layer,
    /// and its exposure is automatic. Throws InputError also for a level or layer that the port does not
    /// have.
    void look(PictureChoice choice);
    /// Sets the exposure so that the next frame's picture is neither black nor white.
    void exposeAutomatically();
    void resize(graph::Extent size);

    /// The camera, to be moved; the next frame is seen from there.
    OrbitCamera& moveCamera();
    void frameObject();
    void resetCamera();

    void play(bool playing);
    void step();

    /// Whether a frame has to be rendered: something was changed, or time runs.
    bool isDirty() const;
    bool hasChanged() const { return isDirty_; }
    /// Renders a frame. Throws RunError.
    void render();

    /// Whether what is shown was made from that file: it is not to be written over.
    bool reads(const std::filesystem::path& file) const;

    const document::GraphDocument& document() const { return document_; }
    const runtime::Session& session() const { return *session_; }
    const PictureChoice& choice() const { return choice_; }
    const PassTimes& times() const { return times_; }
    const OrbitCamera& camera() const { return camera_; }
    double time() const { return time_; }
    bool isPlaying() const { return playing_; }
    graph::Extent size() const { return session_->plan().view; }
    bool isDeviceLost() const;

    /// The looked-at port in the last frame, at the chosen level and layer: its true values. Read when first
    /// asked for. Throws RunError if nothing computes it.
    const image::Image& values();
    /// Nothing without a reference. Computed anew for another frame. Throws InputError if the two cannot be
    /// compared.
    const std::optional<image::ReferenceError>& error();
    const std::optional<image::Image>& reference() const { return reference_; }

    /// What was looked at, as the screen shows it or with its true values.
    void writePng(const std::filesystem::path& file);
    void writeExr(const std::filesystem::path& file);

  private:
    using Clock = std::chrono::steady_clock;

    document::Extras extras() const { return {{}, displayOf(choice_)}; }
    void showDocument();
    template<class Edit>
    void edit(Edit edit);
    graph::Subresources shownPart() const;
    void stayInRange();
    void note(const document::Rebase& rebase);
    void readDocumentAnew(runtime::Reload& saved);
    void applyChoice();
    void setExposure();
    void markDirty();

    runtime::SessionOptions options_;
    document::GraphDocument document_;
    PictureChoice choice_;
    std::unique_ptr<runtime::Session> session_;
    document::LiveGraph live_;
    std::unique_ptr<runtime::LiveReload> reload_;
    scene::CameraDescription sceneCamera_;  ///< as the scene's file has it
    OrbitCamera camera_;
    PassTimes times_;
    double time_ = 0;
    bool playing_ = false;
    Clock::time_point lastTick_;
    bool isDirty_ = true;
    bool wantsExposure_ = true;
    std::uint32_t framesToSettle_ = 0;  ///< of a graph that remembers: frames until its picture is at rest

    std::vector<std::string> notes_;
    std::optional<image::Image> values_;
    std::optional<image::Image> reference_;
    std::optional<image::ReferenceError> error_;
};

}  // namespace nephrite::view
