// Following edges both ways.
#include "view/graph_reach.h"

namespace nephrite::view {
namespace {

void follow(const graph::GraphDrawing& drawing, graph::Index from, Reach mark, std::vector<Reach>& marks) {
    std::vector<graph::Index> open{from};
    while (!open.empty()) {
        const graph::Index node = open.back();
        open.pop_back();
        for (const graph::DrawnEdge& edge : drawing.edges) {
            if (edge.kind == graph::EdgeKind::Off) continue;
            const graph::Index here = mark == Reach::Fed ? edge.from : edge.to;
            const graph::Index there = mark == Reach::Fed ? edge.to : edge.from;
            if (here != node || marks[there] != Reach::None) continue;
            marks[there] = mark;
            open.push_back(there);
        }
    }
}

}  // namespace

std::vector<Reach> reachOf(const graph::GraphDrawing& drawing, graph::Index selected) {
    std::vector<Reach> marks(drawing.nodes.size(), Reach::None);
    if (selected >= marks.size()) return marks;
    marks[selected] = Reach::Itself;
    follow(drawing, selected, Reach::Needed, marks);
    follow(drawing, selected, Reach::Fed, marks);
    return marks;
}

}  // namespace nephrite::view
