// See graphviz.h.
#include "graph/graphviz.h"

#include <fmt/format.h>
#include <graphviz/cgraph.h>

namespace nephrite::graph {
namespace {

/// Laying out takes more than linear time and, inside Graphviz, stack; this many take seconds.
constexpr std::size_t mostNodes = 2000;

struct FreeContext {
    void operator()(GVC_t* context) const { gvFreeContext(context); }
};
struct FreeRendering {
    void operator()(char* data) const { gvFreeRenderData(data); }
};

[[noreturn]] void fail(std::string_view step) {
    const char* reason = aglasterr();
    throw RunError(fmt::format("Graphviz could not {} the plan{}{}", step, reason == nullptr ? "" : ": ",
                               reason == nullptr ? "" : reason));
}

/// Graphviz's text plugin remembers the name of the last font by an address inside the context that drew it,
/// and looks there again when the next drawing starts. So one context lasts as long as the program.
GVC_t* sharedContext() {
    static const std::unique_ptr<GVC_t, FreeContext> context(gvContext());
    if (!context) fail("start to draw");
    agseterr(AGMAX);  // errors are thrown, not printed
    return context.get();
}

}  // namespace

void requireDrawable(const Plan& plan) {
    if (plan.nodes.size() <= mostNodes) return;
    throw RunError(
        fmt::format("a picture of {} nodes is more than Graphviz lays out in reasonable time, at most {}",
                    plan.nodes.size(), mostNodes));
}

GraphvizLayout::GraphvizLayout(const std::string& dot)
    : context_(sharedContext()), graph_(agmemread(dot.c_str())) {
    if (!graph_) fail("read");
    if (gvLayout(context_, graph_.get(), "dot") != 0) fail("lay out");
}

GraphvizLayout::~GraphvizLayout() {
    gvFreeLayout(context_, graph_.get());
}

std::string GraphvizLayout::asSvg() const {
    char* data = nullptr;
    unsigned int size = 0;
    const int status = gvRenderData(context_, graph_.get(), "svg", &data, &size);
    const std::unique_ptr<char, FreeRendering> rendering(data);
    if (status != 0 || data == nullptr) fail("draw");
    return {data, size};
}

}  // namespace nephrite::graph
