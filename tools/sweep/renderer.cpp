// Changing a session from run to run.
#include "sweep/renderer.h"

#include <algorithm>

#include "runtime/draft.h"

namespace nephrite::sweep {
namespace {

/// What of a port has to be asked for beside the graph's outputs.
std::vector<std::string> dumpsFor(const std::string& port) {
    return port.find('.') == std::string::npos ? std::vector<std::string>() : std::vector{port};
}

bool hasHistory(const graph::Plan& plan) {
    return std::any_of(plan.resources.begin(), plan.resources.end(), [](const graph::Resource& resource) {
        return resource.kind == graph::ResourceKind::History;
    });
}

}  // namespace

runtime::SessionOptions Renderer::optionsOf(const Run& run) const {
    runtime::SessionOptions options;
    options.graph = run.graph->file;
    options.scene = run.scene->file;
    options.size = run.size;
    options.settings = run.settings();
    options.dumps = dumpsFor(sweep_.port);
    options.time = sweep_.time;
    options.device = settings_.device;
    options.passPaths = settings_.passPaths;
    options.skip = run.graph->skip;
    options.profile = settings_.profile;
    return options;
}

/// History would go on from one run to the next, and so it depended on which runs were done before.
bool Renderer::canChangeTo(const Run& run) const {
    return session_ && graph_->skip == run.graph->skip && !hasHistory(session_->plan());
}

runtime::Session& Renderer::show(const Run& run) {
    if (!canChangeTo(run)) {
        session_.reset();
        session_.emplace(optionsOf(run));
    } else {
        runtime::DraftRequest request;
        request.graph = {run.graph->file, run.settings(), dumpsFor(sweep_.port)};
        request.scene = run.scene->file;
        request.readScene = run.scene != scene_;
        runtime::Draft draft = session_->draft(std::move(request));
        draft.build();
        session_->adopt(draft);
        if (run.size != size_) session_->resize(run.size);
    }
    scene_ = run.scene;
    graph_ = run.graph;
    size_ = run.size;
    return *session_;
}

}  // namespace nephrite::sweep
