// Changing what a session shows, and rendering it.
#include "view/workbench.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "gpu/device.h"
#include "image/exr.h"
#include "image/png.h"
#include "image/tone_map.h"
#include "runtime/loading/graph_loading.h"
#include "scene/scene.h"
#include "text/same_file.h"

namespace nephrite::view {
namespace {

/// Frames until a picture that remembers earlier ones counts as at rest.
constexpr std::uint32_t settlingFrames = 64;
constexpr double secondsPerStep = 1.0 / 30;

std::shared_ptr<const graph::PassLibrary> readPassTypes(const runtime::SessionOptions& options) {
    return runtime::loadPassTypes(runtime::DataFolders::find(), options.passPaths);
}

document::GraphDocument openDocument(const runtime::SessionOptions& options) {
    document::GraphDocument document(options.graph, readPassTypes(options));
    for (const std::string& setting : options.settings) {
        const std::size_t equals = setting.find('=');
        if (equals == std::string::npos || equals == 0)
            throw InputError({"--set " + setting}, "expected NODE.PARAM=JSON or PARAM=JSON");
        document.set(setting.substr(0, equals), setting.substr(equals + 1));
    }
    return document;
}

/// The output "color" if there is one, else the first.
PictureChoice firstChoice(const graph::LinkedGraph& graph) {
    const auto& outputs = graph.description.outputs;
    const auto color = std::find_if(outputs.begin(), outputs.end(),
                                    [](const auto& output) { return output.first == "color"; });
    PictureChoice choice;
    choice.port = graph::toText((color == outputs.end() ? outputs.front() : *color).second);
    return choice;
}

runtime::SessionOptions withDisplay(runtime::SessionOptions options, const PictureChoice& choice) {
    options.display = displayOf(choice);
    return options;
}

void requireInside(const PictureChoice& choice, const char* what, std::uint32_t index, std::uint32_t count) {
    if (index == 0 || index < count) return;
    throw InputError({choice.port},
                     count < 2 ? fmt::format("it has no {} but 0", what)
                               : fmt::format("expected a {} from 0 to {}, found {}", what, count - 1, index));
}

image::Metadata metadataOf(const runtime::SessionOptions& options, const PictureChoice& choice, double time) {
    return {{"graph", options.graph.string()},
            {"scene", options.scene.empty() ? "default" : options.scene.string()},
            {"port", choice.port},
            {"time", fmt::format("{:.17g}", time)}};
}

}  // namespace

Workbench::Workbench(runtime::SessionOptions options, std::function<void()> onSaved)
    : options_(std::move(options)),
      document_(openDocument(options_)),
      choice_(firstChoice(*document_.graph())),
      session_(std::make_unique<runtime::Session>(withDisplay(options_, choice_))),
      live_(*session_, document_, extras()),
      reload_(std::make_unique<runtime::LiveReload>(*session_, std::move(onSaved))),
      sceneCamera_(session_->scene().description().camera),
      camera_(sceneCamera_),
      time_(options_.time) {}

void Workbench::markDirty() {
    isDirty_ = true;
    framesToSettle_ = session_->plan().graph->hasHistory ? settlingFrames : 0;
}

void Workbench::showDocument() {
    if (!live_.show(document_, extras())) return;
    reload_->watchAnew();
    markDirty();
}

std::optional<runtime::Reload> Workbench::takeSaved() {
    std::optional<runtime::Reload> saved = reload_->poll();
    if (!saved) return saved;
    if (saved->faults.empty()) readDocumentAnew(*saved);
    const scene::CameraDescription& camera = session_->scene().description().camera;
    if (!(camera == sceneCamera_)) camera_ = OrbitCamera(sceneCamera_ = camera);
    markDirty();
    return saved;
}

/// Once it was edited, the graph's text is the document's and no longer that of the file.
void Workbench::readDocumentAnew(runtime::Reload& saved) {
    try {
        document_.setPassTypes(readPassTypes(options_));
        note(document_.reload());
        showDocument();
    } catch (const InputError& error) {
        saved.faults = error.faults();
        saved.shown = false;
    }
}

/// An edit that was to stand may be dropped in the end: then only that is said.
void Workbench::note(const document::Rebase& rebase) {
    const std::string file = document_.file().filename().string();
    for (const std::string& path : rebase.overruled) {
        const bool isDropped =
            std::any_of(rebase.dropped.begin(), rebase.dropped.end(),
                        [&](const std::string& edit) { return edit.starts_with(path + ":"); });
        if (!isDropped)
            notes_.push_back(
                fmt::format("{}: warning: {} was changed in the file too; the edit here stands", file, path));
    }
    for (const std::string& edit : rebase.dropped)
        notes_.push_back(
            fmt::format("{}: warning: an edit no longer fits the file and was dropped: {}", file, edit));
}

/// Changes the document and shows it, or leaves both as they were.
template<class Edit>
void Workbench::edit(Edit edit) {
    document::GraphDocument before = document_;
    try {
        edit();
        showDocument();
    } catch (...) {
        document_ = std::move(before);
        throw;
    }
}

void Workbench::set(const std::string& target, const std::string& json, document::Gesture gesture) {
    edit([&] { document_.set(target, json, gesture); });
}

void Workbench::reset(const std::string& target) {
    edit([&] { document_.reset(target); });
}

void Workbench::switchNode(const std::string& node, bool on) {
    edit([&] { document_.switchNode(node, on); });
}

void Workbench::swapPass(const std::string& node, const std::string& passType) {
    edit([&] { document_.swapPass(node, passType); });
}

void Workbench::undo() {
    edit([&] { document_.undo(); });
}

void Workbench::redo() {
    edit([&] { document_.redo(); });
}

void Workbench::save() {
    note(document_.save());
    showDocument();
}

/// The levels and layers of what is looked at; none where nothing computes it.
graph::Subresources Workbench::shownPart() const {
    const auto exported = session_->exported(graph::valuesName);
    return exported ? exported->part : graph::Subresources{0, 0, 0, 0};
}

/// An edit may have taken the level or layer away that was looked at.
void Workbench::stayInRange() {
    const graph::Subresources part = shownPart();
    PictureChoice choice = choice_;
    choice.level = std::min(choice.level, std::max(part.mips, 1U) - 1);
    choice.layer = std::min(choice.layer, std::max(part.layers, 1U) - 1);
    look(choice);
}

void Workbench::look(PictureChoice choice) {
    if (choice == choice_) return;
    const bool isOther = choice.port != choice_.port;
    if (isOther) choice.level = choice.layer = 0;
    const graph::Subresources part = shownPart();
    requireInside(choice, "level", choice.level, part.mips);
    requireInside(choice, "layer", choice.layer, part.layers);
    std::optional<image::Image> reference = reference_;
    if (choice.reference.empty()) reference.reset();
    if (!choice.reference.empty() && choice.reference != choice_.reference)
        reference = image::readExr(choice.reference).image;
    const PictureChoice before = std::exchange(choice_, std::move(choice));
    try {
        if (live_.show(document_, extras())) {
            reload_->watchAnew();
            reload_->tryAgain();  // the port or the reference of before may have been what was wrong
        }
        applyChoice();
    } catch (...) {
        choice_ = before;
        throw;
    }
    reference_ = std::move(reference);
    if (isOther) wantsExposure_ = true;
    markDirty();
}

/// The pass `display` in the session gets the parameters of the choice.
void Workbench::applyChoice() {
    for (const std::string& setting : displaySettings(choice_)) {
        session_->set(fmt::format("{}.{}", graph::pictureName, setting));
        if (!choice_.reference.empty()) session_->set(fmt::format("{}.{}", graph::referenceName, setting));
    }
}

void Workbench::exposeAutomatically() {
    wantsExposure_ = true;
    isDirty_ = true;
}

/// Signed values and depths have no brightness to go by.
void Workbench::setExposure() {
    wantsExposure_ = false;
    PictureChoice choice = choice_;
    choice.exposure = image::automaticExposure(values());
    look(choice);
}

void Workbench::resize(graph::Extent size) {
    session_->resize(size);
    options_.size = size;
    markDirty();
}

OrbitCamera& Workbench::moveCamera() {
    markDirty();
    return camera_;
}

void Workbench::frameObject() {
    moveCamera().frame(session_->scene().boundingSphere(time_), size().width, size().height);
}

void Workbench::resetCamera() {
    moveCamera() = OrbitCamera(session_->scene().description().camera);
}

void Workbench::play(bool playing) {
    playing_ = playing;
    lastTick_ = Clock::now();
    markDirty();
}

void Workbench::step() {
    playing_ = false;
    time_ += secondsPerStep;
    markDirty();
}

bool Workbench::isDirty() const {
    return isDirty_ || playing_ || framesToSettle_ > 0;
}

void Workbench::render() {
    if (playing_) {
        const Clock::time_point now = Clock::now();
        time_ += std::chrono::duration<double>(now - lastTick_).count();
        lastTick_ = now;
    }
    if (framesToSettle_ > 0) --framesToSettle_;
    isDirty_ = false;  // a frame that fails is not tried again until something changes
    values_.reset();
    error_.reset();
    stayInRange();
    session_->setCamera(camera_.description());
    times_.add(session_->plan(), session_->renderFrame(time_));
    if (wantsExposure_) setExposure();
}

bool Workbench::isDeviceLost() const {
    return session_->device().lost();
}

const image::Image& Workbench::values() {
    if (!values_) values_ = session_->read(graph::valuesName, choice_.level, choice_.layer);
    return *values_;
}

const std::optional<image::ReferenceError>& Workbench::error() {
    if (!error_ && reference_) error_ = image::errorAgainst(values(), *reference_);
    return error_;
}

bool Workbench::reads(const std::filesystem::path& file) const {
    std::vector<std::filesystem::path> files = session_->files();
    files.push_back(choice_.reference);
    return isAmong(file, files);
}

void Workbench::writePng(const std::filesystem::path& file) {
    const image::Image shown = session_->read(graph::pictureName);
    image::ByteImage picture{shown.width, shown.height, 3, {}};
    picture.pixels.reserve(std::size_t{shown.width} * shown.height * 3);
    for (std::uint32_t y = 0; y < shown.height; ++y)
        for (std::uint32_t x = 0; x < shown.width; ++x)
            for (std::uint32_t c = 0; c < 3; ++c)
                picture.pixels.push_back(static_cast<std::uint8_t>(std::lround(shown.at(x, y, c) * 255)));
    image::writePng(file, picture);
}

void Workbench::writeExr(const std::filesystem::path& file) {
    image::writeExr(file, values(), metadataOf(options_, choice_, time_));
}

}  // namespace nephrite::view
