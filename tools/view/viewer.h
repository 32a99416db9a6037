// The viewer: a window, a workbench, and the loop that brings them together. It draws when something has
// changed and sleeps otherwise; whatever fails is shown over the picture, and the last good picture stays.
#pragma once

#include <filesystem>
#include <memory>

#include "gpu/frame_presenter.h"
#include "view/fault_list.h"
#include "view/layout.h"
#include "view/script.h"
#include "view/stage.h"
#include "view/user_interface.h"
#include "view/view_state.h"
#include "view/window.h"
#include "view/workbench.h"

namespace nephrite::view {

struct ViewerOptions {
    runtime::SessionOptions session;
    std::filesystem::path script;  ///< commands, a line each; "-": standard input; empty: none
    int width = 1280;
    int height = 860;
};

class Viewer {
  public:
    /// Opens the window. Throws InputError or RunError: then there was nothing to show in the first place.
    explicit Viewer(const ViewerOptions& options);

    /// Returns when the window is closed. Throws RunError if the device is lost, and at the end if the
    /// validation layer said anything.
    void run();

    Workbench& bench() { return bench_; }
    ViewState& state() { return state_; }
    /// What is wrong now, a line each.
    std::vector<std::string> bannerLines() const;
    Window& window() { return window_; }
    /// Ends run(). With edits that are not saved this throws InputError the first time, which says so.
    void close();
    /// Where the picture is in the window; that of the reference, if there is one.
    const PicturePlacement& placement() const { return placement_; }
    const std::optional<PicturePlacement>& referencePlacement() const { return referencePlacement_; }
    const Layout& layout() const { return layout_; }

    /// Values and error of what is looked at; nothing if they cannot be read.
    const image::Image* valuesIfKnown();
    std::optional<image::ReferenceError> errorIfKnown();

    /// Runs a change of the user's; what it throws is shown.
    void attempt(const std::function<void()>& action);

  private:
    void betweenFrames();
    void takeSaved();
    std::string answer();
    void answerScript();
    void takeCloseRequest();
    bool hasWork() const;
    void guarded(const std::function<void()>& work);
    bool wantsFrame() const;
    void render();
    void forgetPictures();
    void placePictures(VkExtent2D pixels);
    void draw(VkExtent2D pixels);
    std::vector<ShownImage> shownImages(VkExtent2D pixels) const;
    void present(const std::vector<ShownImage>& images);
    void write(const image::ByteImage& picture, const std::filesystem::path& file);
    void reportOfCommand(std::vector<std::string> lines);
    void showNotes();
    void updateTitle();

    WindowLibrary library_;
    Window window_;
    Workbench bench_;
    gpu::Surface surface_;
    gpu::FramePresenter presenter_;
    std::unique_ptr<UserInterface> controls_;  ///< when there is a window to draw in
    ViewState state_;
    FaultList faults_;         ///< of the last thing that the user did
    FaultList fileFaults_;     ///< of files as they are saved
    FaultList frameFaults_;    ///< of the last frame of the graph
    FaultList drawingFaults_;  ///< of the window's last picture
    Layout layout_;
    PicturePlacement placement_;
    std::optional<PicturePlacement> referencePlacement_;
    std::unique_ptr<Script> script_;
    bool answers_ = false;        ///< a command of the script was run and its picture is not shown yet
    std::uint32_t pictures_ = 0;  ///< to draw until the controls are at rest
    bool isSeen_ = true;          ///< the window is not minimised
    bool isClosed_ = false;
    std::string knownEdits_;  ///< the graph's text whose edits the user knows that closing drops
    std::string title_;
};

}  // namespace nephrite::view
