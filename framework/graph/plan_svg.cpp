// A plan drawn by Graphviz's library.
#include <fmt/format.h>
#include <graphviz/cgraph.h>
#include <graphviz/gvc.h>

#include <memory>

#include "graph/plan_writer.h"

namespace nephrite::graph {
namespace {

/// Laying out takes more than linear time and, inside Graphviz, stack; this many take seconds.
constexpr std::size_t mostNodes = 2000;

struct FreeContext {
    void operator()(GVC_t* context) const { gvFreeContext(context); }
};
struct CloseGraph {
    void operator()(Agraph_t* graph) const { agclose(graph); }
};
struct FreeRendering {
    void operator()(char* data) const { gvFreeRenderData(data); }
};
using Context = std::unique_ptr<GVC_t, FreeContext>;
using Graph = std::unique_ptr<Agraph_t, CloseGraph>;
using Rendering = std::unique_ptr<char, FreeRendering>;

/// Graphviz's text plugin remembers the name of the last font by an address inside the context that drew it,
/// and looks there again when the next drawing starts. So one context lasts as long as the program.
GVC_t* sharedContext() {
    static const Context context(gvContext());
    return context.get();
}

[[noreturn]] void fail(std::string_view step) {
    const char* reason = aglasterr();
    throw RunError(fmt::format("Graphviz could not {} the plan{}{}", step, reason == nullptr ? "" : ": ",
                               reason == nullptr ? "" : reason));
}

/// A laid-out graph: the layout is undone before the graph is closed.
class Drawing {
  public:
    Drawing(GVC_t* context, Agraph_t* graph) : context_(context), graph_(graph) {
        if (gvLayout(context_, graph_, "dot") != 0) fail("lay out");
    }
    ~Drawing() { gvFreeLayout(context_, graph_); }
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;

    std::string asSvg() const {
        char* data = nullptr;
        unsigned int size = 0;
        const int status = gvRenderData(context_, graph_, "svg", &data, &size);
        const Rendering rendering(data);
        if (status != 0 || data == nullptr) fail("draw");
        return {data, size};
    }

  private:
    GVC_t* context_;
    Agraph_t* graph_;
};

}  // namespace

std::string planAsSvg(const Plan& plan) {
    if (plan.nodes.size() > mostNodes) {
        throw RunError(
            fmt::format("a picture of {} nodes is more than Graphviz lays out in reasonable time, at most {}",
                        plan.nodes.size(), mostNodes));
    }
    agseterr(AGMAX);  // errors are thrown, not printed
    GVC_t* context = sharedContext();
    if (context == nullptr) fail("start to draw");
    const Graph graph(agmemread(planAsDot(plan).c_str()));
    if (!graph) fail("read");
    return Drawing(context, graph.get()).asSvg();
}

}  // namespace nephrite::graph
