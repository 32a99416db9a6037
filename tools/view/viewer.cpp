// The loop of the viewer.
#include "view/viewer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "gpu/device.h"
#include "image/png.h"
#include "text/fault_lines.h"
#include "view/mouse.h"
#include "view/panels/panels.h"

namespace nephrite::view {
namespace {

/// The controls look at input once more after it has come, and some only then know how large they are.
constexpr std::uint32_t picturesToRest = 3;
/// The longest sleep: nothing depends on it, as whatever happens wakes the window.
constexpr double longestSleep = 5;
constexpr double gapBetweenPictures = 4;

runtime::SessionOptions forWindow(runtime::SessionOptions options, const WindowLibrary& library) {
    options.presentation = std::make_shared<const gpu::Presentation>(library.presentation());
    options.reuse = true;
    options.profile = true;
    return options;
}

}  // namespace

Viewer::Viewer(const ViewerOptions& options)
    : window_(library_, "Nephrite", options.width, options.height),
      bench_(forWindow(options.session, library_), Window::wake),
      surface_(window_.makeSurface(bench_.session().device().instance())),
      presenter_(bench_.session().device(), surface_.get(), gpu::PresentMode::Fifo) {
    for (const Diagnostic& warning : bench_.session().diagnostics().warnings())
        fmt::print(stderr, "{}\n", toLine(warning, "warning"));
    if (!options.script.empty()) script_ = std::make_unique<Script>(options.script, Window::wake);
    knownEdits_ = bench_.document().text();  // those of --set
}

void Viewer::attempt(const std::function<void()>& action) {
    const FaultList before = faults_;
    faults_.attempt(action);
    if (state_.answersWithAllFaults) faults_ = before;  // asking changes nothing
    showNotes();
    if (bench_.isDeviceLost()) throw RunError("the device was lost");
}

void Viewer::showNotes() {
    std::vector<std::string> notes = bench_.takeNotes();
    if (!notes.empty()) faults_.report(std::move(notes));
}

const image::Image* Viewer::valuesIfKnown() {
    try {
        return &bench_.values();
    } catch (const std::runtime_error&) {
        return nullptr;  // the inspector says what there is to see instead
    }
}

std::optional<image::ReferenceError> Viewer::errorIfKnown() {
    return valuesIfKnown() == nullptr ? std::nullopt : bench_.error();
}

void Viewer::run() {
    while (!isClosed_) {
        if (hasWork())
            window_.poll();
        else
            window_.wait(longestSleep);
        if (window_.takeActivity()) pictures_ = picturesToRest;
        takeCloseRequest();
        presenter_.waitForAll();
        betweenFrames();
        const VkExtent2D pixels = window_.pixels();
        isSeen_ = pixels.width != 0 && pixels.height != 0;
        if (wantsFrame()) render();
        if (!isSeen_) forgetPictures();
        if (pictures_ > 0)
            guarded([&] {
                if (presenter_.prepare(pixels)) draw(pixels);
            });
        answerScript();
    }
    if (answers_) script_->answer(answer());
    if (const std::size_t count = bench_.session().device().validationMessages(); count != 0)
        throw RunError(fmt::format("{} validation message{}", count, count == 1 ? "" : "s"));
    if (script_) script_->requireAllDone();
}

void Viewer::close() {
    const document::GraphDocument& document = bench_.document();
    if (document.isModified() && document.text() != knownEdits_) {
        knownEdits_ = document.text();
        throw InputError({document.file().filename().string()},
                         "it has edits that are not saved: save them, or close again to drop them");
    }
    isClosed_ = true;
}

/// Of the desktop.
void Viewer::takeCloseRequest() {
    if (window_.takeCloseRequest()) attempt([&] { close(); });
}

/// Does what is no change of the user's: if it succeeds, what an earlier change threw is still to be seen.
void Viewer::guarded(const std::function<void()>& work) {
    try {
        work();
        drawingFaults_.clear();
    } catch (const std::exception& error) {
        drawingFaults_.report(linesOf(error));
        pictures_ = std::min(pictures_, 1U);  // not to fail again and again without a rest
    }
    if (bench_.isDeviceLost()) throw RunError("the device was lost");
}

/// A window that cannot be seen shows what was changed when it is seen again, but nothing moves meanwhile.
bool Viewer::wantsFrame() const {
    return isSeen_ ? bench_.isDirty() : bench_.hasChanged();
}

void Viewer::render() {
    frameFaults_.attempt([&] { bench_.render(); });
    if (bench_.isDeviceLost()) throw RunError("the device was lost");
    pictures_ = std::max(pictures_, 1U);
}

void Viewer::forgetPictures() {
    pictures_ = 0;
    if (!state_.windowCapture) return;
    state_.windowCapture.reset();
    reportOfCommand({"nephrite: error: a minimised window has no picture to write"});
}

/// Here, and while the controls are made, what is shown may change: nothing of it is being drawn.
void Viewer::betweenFrames() {
    takeSaved();
    if (!script_ || answers_ || !script_->hasNext()) return;
    if (wantsFrame() && !bench_.isPlaying()) return;  // what it says is of the picture before it
    attempt([&] { script_->runNext(*this); });
    answers_ = true;
    pictures_ = picturesToRest;
}

void Viewer::takeSaved() {
    const std::optional<runtime::Reload> saved = bench_.takeSaved();
    if (!saved) return;
    showNotes();
    const std::vector<std::string> lines = toLines(*saved);
    if (saved->faults.empty()) {
        fileFaults_.clear();
        state_.message = lines.empty() ? std::string() : lines.back();
    } else {
        fileFaults_.report(lines);
    }
    pictures_ = picturesToRest;
}

std::vector<std::string> Viewer::bannerLines() const {
    std::vector<std::string> lines;
    for (const FaultList* list : {&faults_, &fileFaults_, &frameFaults_, &drawingFaults_})
        lines.insert(lines.end(), list->lines().begin(), list->lines().end());
    return lines;
}

/// The answer to a command comes when its picture is shown, so that who waits for it sees what it did. While
/// time runs there is always a next picture, and the first few are waited for.
void Viewer::answerScript() {
    if (!answers_ || pictures_ > 0 || (wantsFrame() && !bench_.isPlaying())) return;
    answers_ = false;
    script_->answer(answer());
}

/// What became of the last command and its picture. A file that is wrong is not its doing.
std::string Viewer::answer() {
    if (std::exchange(state_.answersWithAllFaults, false)) {
        const std::vector<std::string> lines = bannerLines();
        return lines.empty() ? "ok" : fmt::format("{}", fmt::join(lines, "; "));
    }
    for (const FaultList* list : {&faults_, &frameFaults_, &drawingFaults_})
        if (!list->lines().empty()) return list->lines().front();
    return "ok";
}

bool Viewer::hasWork() const {
    const bool isAnswered = !answers_ && script_ && script_->hasNext();
    return pictures_ > 0 || wantsFrame() || isAnswered;
}

void Viewer::placePictures(VkExtent2D pixels) {
    const float scale = window_.contentScale();
    const LowerPart lower = !state_.showsLower                  ? LowerPart::Hidden
                            : state_.openTab == LowerTab::Graph ? LowerPart::High
                                                                : LowerPart::Low;
    layout_ = layOut(pixels.width, pixels.height, ImGui::GetFrameHeight() + 8 * scale, scale, lower);
    const auto place = [&](const Area& area, const char* name) {
        const auto exported = bench_.session().exported(name);
        const VkExtent2D extent = exported ? exported->image->extent() : VkExtent2D{0, 0};
        PicturePlacement placement(area, extent.width, extent.height);
        placement.magnify(state_.magnification.factor, state_.magnification.center);
        return placement;
    };
    referencePlacement_.reset();
    if (bench_.choice().reference.empty()) {
        placement_ = place(layout_.picture, graph::pictureName);
        return;
    }
    const Halves halves = halvesOf(layout_.picture, gapBetweenPictures * scale);
    placement_ = place(halves.left, graph::pictureName);
    referencePlacement_ = place(halves.right, graph::referenceName);
}

void Viewer::draw(VkExtent2D pixels) {
    if (!controls_)
        controls_ = std::make_unique<UserInterface>(window_, bench_.session().device(), presenter_);
    placePictures(pixels);
    controls_->draw([&] {
        followMouse(*this);
        followKeys(*this);
        drawPanels(*this);
    });
    if (bench_.hasChanged()) render();
    placePictures(pixels);
    present(shownImages(pixels));
    updateTitle();
}

std::vector<ShownImage> Viewer::shownImages(VkExtent2D pixels) const {
    std::vector<ShownImage> images;
    const auto add = [&](const PicturePlacement& placement, const char* name) {
        const auto exported = bench_.session().exported(name);
        const auto blit =
            placement.blit(static_cast<std::int32_t>(pixels.width), static_cast<std::int32_t>(pixels.height));
        if (exported && blit) images.push_back({exported->image, *blit});
    };
    add(placement_, graph::pictureName);
    if (referencePlacement_) add(*referencePlacement_, graph::referenceName);
    return images;
}

void Viewer::present(const std::vector<ShownImage>& images) {
    Stage stage(bench_.session().device(), presenter_, *controls_);
    // The controls are at rest in the last of several pictures.
    if (!state_.windowCapture || pictures_ > 1) {
        if (stage.show(images)) --pictures_;
        return;
    }
    const auto picture = stage.showAndCapture(images);
    if (!picture) return;
    --pictures_;
    write(*picture, *std::exchange(state_.windowCapture, std::nullopt));
}

/// What an earlier change threw is still to be seen, for a picture of the window may be taken to show it.
void Viewer::write(const image::ByteImage& picture, const std::filesystem::path& file) {
    try {
        image::writePng(file, picture);
        state_.message = "wrote " + file.string();
        pictures_ = std::max(pictures_, 1U);
    } catch (const std::exception& error) {
        reportOfCommand(linesOf(error));
    }
}

/// A picture of the window is written after the command that asked for it.
void Viewer::reportOfCommand(std::vector<std::string> lines) {
    faults_.report(answers_ ? script_->placed(std::move(lines)) : std::move(lines));
}

void Viewer::updateTitle() {
    const auto& document = bench_.document();
    std::string title =
        fmt::format("{}{} - Nephrite", document.isModified() ? "*" : "", document.file().filename().string());
    if (title == title_) return;
    title_ = std::move(title);
    window_.setTitle(title_);
}

}  // namespace nephrite::view
