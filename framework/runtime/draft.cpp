// Building a draft.
#include "runtime/draft.h"

#include <algorithm>
#include <chrono>

#include "runtime/draft_state.h"

namespace nephrite::runtime {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

std::filesystem::path fullPath(const std::filesystem::path& file) {
    return std::filesystem::absolute(file).lexically_normal();
}

}  // namespace

Draft::Draft(std::unique_ptr<State> state) : state_(std::move(state)) {}
Draft::~Draft() = default;
Draft::Draft(Draft&&) noexcept = default;

void Draft::build() {
    State& draft = *state_;
    const Clock::time_point start = Clock::now();
    draft.readAt = std::chrono::file_clock::now();
    const DraftRequest& request = draft.request;
    if (request.readScene)
        draft.scene =
            std::make_shared<const scene::Scene>(loadScene(request.scene, draft.options.time, draft.folders));
    if (request.readGraph)
        draft.content =
            GraphContent(request.graph, draft.folders, draft.options.passPaths, &draft.content.graph());
    draft.times.readMs = millisecondsSince(start);

    const Clock::time_point afterReading = Clock::now();
    if (request.readGraph) draft.programs.readFilesAnew();
    buildPrograms(makePlans(draft.planning(), draft.content, draft.scene->facts(), draft.programs),
                  draft.content, draft.programs);
    draft.times.driverMs = draft.programs.buildMs();
    draft.times.compileMs = millisecondsSince(afterReading) - draft.times.driverMs;
}

void Draft::buildAfter(const std::vector<std::filesystem::path>& saved) {
    std::vector<std::filesystem::path> ofScene;
    for (const std::filesystem::path& file : state_->scene->files()) {
        std::error_code ignored;
        ofScene.push_back(file);
        ofScene.push_back(std::filesystem::canonical(file, ignored));  // where a link leads
    }
    const auto isOfScene = [&](const std::filesystem::path& file) {
        return std::find(ofScene.begin(), ofScene.end(), file) != ofScene.end();
    };
    state_->request.readScene = std::any_of(saved.begin(), saved.end(), isOfScene);
    state_->request.readGraph = !std::all_of(saved.begin(), saved.end(), isOfScene);
    build();
}

void Draft::warmUp() const {
    state_->programs.context().compiler.warmUp();
}

std::vector<std::filesystem::path> Draft::files() const {
    std::vector<std::filesystem::path> files = filesOf(state_->content, *state_->scene, state_->programs);
    if (state_->request.readGraph) files.push_back(fullPath(state_->request.graph.file));
    if (state_->request.readScene && !state_->request.scene.empty())
        files.push_back(fullPath(state_->request.scene));
    return files;
}

std::vector<std::filesystem::path> filesOf(const GraphContent& content, const scene::Scene& scene,
                                           const ProgramCache& programs) {
    std::vector<std::filesystem::path> files = programs.files();
    const auto add = [&](const std::vector<std::filesystem::path>& more) {
        files.insert(files.end(), more.begin(), more.end());
    };
    add(scene.files());
    add(content.files());
    std::transform(files.begin(), files.end(), files.begin(), fullPath);
    return files;
}

const DraftTimes& Draft::times() const {
    return state_->times;
}
std::uint64_t Draft::pipelines() const {
    return state_->programs.built();
}

}  // namespace nephrite::runtime
