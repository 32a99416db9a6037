// Boxes with name, pass, state and time over the curves of edges.
#include "view/panels/graph_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "view/style.h"

namespace nephrite::view {
namespace {

constexpr float nameSize = 13;
constexpr float portSize = 10.5F;
constexpr float leastSize = 12;  ///< of letters on the screen, where those of the usual size are 14
constexpr float inset = 9;       ///< of text in a box

const ImVec4& colorOf(Outcome outcome) {
    switch (outcome) {
        case Outcome::Runs:
            return color::gpu;
        case Outcome::Kept:
            return color::cpu;
        case Outcome::Skipped:
            return color::skipped;
        case Outcome::Culled:
            return color::quiet;
        case Outcome::Output:
            break;
    }
    return ImGui::GetStyle().Colors[ImGuiCol_Text];
}

ImVec4 colorOfEdge(graph::EdgeKind kind) {
    switch (kind) {
        case graph::EdgeKind::Flow:
            return color::accent;
        case graph::EdgeKind::History:
            return color::changed;
        case graph::EdgeKind::Tiles:
            return color::cpu;
        case graph::EdgeKind::Off:
            return color::quiet;
    }
    return color::quiet;
}

class Painter {
  public:
    explicit Painter(const GraphPicture& picture)
        : picture_(picture),
          list_(*ImGui::GetWindowDrawList()),
          font_(*ImGui::GetFont()),
          anySelected_(std::find(picture.reach.begin(), picture.reach.end(), Reach::Itself) !=
                       picture.reach.end()) {}

    void paint() {
        const auto& drawing = picture_.view.drawing;
        for (graph::Index i = 0; i < drawing.edges.size(); ++i)
            if (!isMarked(drawing.edges[i])) paintEdge(i);
        for (graph::Index i = 0; i < drawing.edges.size(); ++i)
            if (isMarked(drawing.edges[i])) paintEdge(i);
        if (picture_.view.zoom >= zoomForPorts) paintLabels();
        for (graph::Index i = 0; i < drawing.nodes.size(); ++i)
            paintNode(drawing.nodes[i], picture_.reach[i]);
    }

  private:
    float lettersFor(float size) const {
        return std::max(size * picture_.view.zoom, leastSize) * picture_.unit;
    }
    bool isMarked(const graph::DrawnEdge& edge) const {
        return picture_.reach[edge.from] != Reach::None && picture_.reach[edge.to] != Reach::None;
    }

    void paintEdge(graph::Index index) {
        const graph::DrawnEdge& edge = picture_.view.drawing.edges[index];
        ImVec4 color = colorOfEdge(edge.kind);
        float width = std::max(1.0F, 1.4F * picture_.zoom());
        if (anySelected_ && isMarked(edge)) {
            const bool isNeeded = picture_.reach[edge.from] == Reach::Needed;
            color = isNeeded ? color::changed : color::fed;
            width = std::max(2.0F, width);
        } else {
            color.w = anySelected_ ? 0.15F : 0.85F;
        }
        if (index == picture_.hoveredEdge) {
            color = ImGui::GetStyle().Colors[ImGuiCol_Text];
            width += 1;
        }
        for (std::size_t i = 0; i + 3 < edge.curve.size(); i += 3)
            list_.AddBezierCubic(picture_.at(edge.curve[i]), picture_.at(edge.curve[i + 1]),
                                 picture_.at(edge.curve[i + 2]), picture_.at(edge.curve[i + 3]),
                                 ImGui::GetColorU32(color), width);
    }

    /// One a port: what leaves it is the same along all of its edges.
    void paintLabels() {
        std::set<std::pair<graph::Index, graph::Index>> labelled;
        for (const graph::DrawnEdge& edge : picture_.view.drawing.edges)
            if ((!anySelected_ || isMarked(edge)) && labelled.insert({edge.from, edge.output}).second)
                paintLabel(edge, 1);
        for (const graph::DrawnEdge& edge : picture_.view.drawing.edges)
            if (labelled.insert({edge.from, edge.output}).second) paintLabel(edge, 0.3F);
    }

    void paintLabel(const graph::DrawnEdge& edge, float visible) {
        const ImVec2 start = picture_.at(edge.labelStart);
        const float size = 9.5F * picture_.zoom();
        const ImVec2 corner{start.x, start.y - size * 0.6F};
        ImVec4 color = color::quiet;
        color.w = visible;
        list_.AddRectFilled(corner, {corner.x + widthOf(edge.label, size), corner.y + size * 1.1F},
                            ImGui::GetColorU32(ImGuiCol_WindowBg, 0.8F));
        text(corner, size, edge.label, ImGui::GetColorU32(color));
    }

    void paintNode(const graph::DrawnNode& node, Reach reach) {
        const ImVec2 corner = picture_.at(node.corner);
        const ImVec2 end = picture_.at({node.corner.x + node.width, node.corner.y + node.height});
        if (!ImGui::IsRectVisible(corner, end)) return;
        ImVec4 state = colorOf(outcomeOf(picture_.plan, node, picture_.times));
        const float visible = anySelected_ && reach == Reach::None ? 0.3F : 1;
        state.w = visible;
        const float rounding = 5 * picture_.zoom();
        list_.AddRectFilled(corner, end, ImGui::GetColorU32(ImGuiCol_WindowBg), rounding);
        ImVec4 fill = state;
        fill.w = 0.22F * visible;
        list_.AddRectFilled(corner, end, ImGui::GetColorU32(fill), rounding);
        const ImVec4 border = reach == Reach::Needed   ? color::changed
                              : reach == Reach::Fed    ? color::fed
                              : reach == Reach::Itself ? ImGui::GetStyle().Colors[ImGuiCol_Text]
                                                       : state;
        list_.AddRect(corner, end, ImGui::GetColorU32(border), rounding, 0,
                      reach == Reach::None ? 1.2F : 2.5F);
        if (picture_.view.zoom < zoomForNames) return;
        list_.PushClipRect(corner, end, true);
        paintText(node, state, visible);
        if (picture_.view.zoom >= zoomForPorts && node.node != graph::noIndex) paintPorts(node, visible);
        list_.PopClipRect();
    }

    /// Name; below it the pass on the left and its time, or why it has none, on the right.
    void paintText(const graph::DrawnNode& node, const ImVec4& state, float visible) {
        const ImVec2 corner = picture_.at(node.corner);
        const float left = corner.x + inset * picture_.unit;
        const float width = node.width * picture_.zoom() - 2 * inset * picture_.unit;
        const float size = lettersFor(nameSize);
        const float top = corner.y + 3 * picture_.zoom();
        text({left, top}, size, shortened(nameOf(picture_.plan, node), size, width),
             ImGui::GetColorU32(ImGuiCol_Text, visible));
        const float second = lettersFor(nameSize) * 0.9F;
        const float below = top + size * 1.2F;
        if (below + second > corner.y + node.height * picture_.zoom()) return;
        const std::string what(name(outcomeOf(picture_.plan, node, picture_.times)));
        const std::string time = timeOf(picture_.plan, node, picture_.times);
        const std::string right = time.empty() ? what : time;  // its colour says what became of it
        const float rightWidth = widthOf(right, second);
        text({left + width - rightWidth, below}, second, right, ImGui::GetColorU32(state));
        ImVec4 quiet = color::quiet;
        quiet.w = visible;
        text({left, below}, second,
             shortened(typeOf(picture_.plan, node), second, width - rightWidth - inset * picture_.unit),
             ImGui::GetColorU32(quiet));
    }

    void paintPorts(const graph::DrawnNode& node, float visible) {
        const graph::PassType& type = *picture_.plan.graph->nodes[node.node].type;
        const float size = portSize * picture_.zoom();
        const ImU32 color = ImGui::GetColorU32(ImGuiCol_Text, 0.8F * visible);
        for (std::size_t i = 0; i < node.inputs.size(); ++i) {
            const ImVec2 place = picture_.at(node.inputs[i]);
            text({place.x + inset * picture_.zoom(), place.y - size * 0.6F}, size,
                 i < type.inputs.size() ? type.inputs[i].name : "tiles", color);
        }
        for (std::size_t i = 0; i < node.outputs.size(); ++i) {
            const ImVec2 place = picture_.at(node.outputs[i]);
            const std::string& name = type.outputs[i].name;
            text({place.x - inset * picture_.zoom() - widthOf(name, size), place.y - size * 0.6F}, size, name,
                 color);
        }
    }

    void text(ImVec2 place, float size, const std::string& words, ImU32 color) {
        list_.AddText(&font_, size, place, color, words.c_str());
    }
    float widthOf(const std::string& words, float size) const {
        return font_.CalcTextSizeA(size, 1e6F, 0, words.c_str()).x;
    }
    std::string shortened(const std::string& words, float size, float width) const {
        return withoutMiddle(words, [&](const std::string& tried) { return widthOf(tried, size) <= width; });
    }

    const GraphPicture& picture_;
    ImDrawList& list_;
    const ImFont& font_;
    bool anySelected_;
};

}  // namespace

std::string nameOf(const graph::Plan& plan, const graph::DrawnNode& node) {
    return node.node == graph::noIndex ? plan.requested[node.requested].name
                                       : plan.graph->nodeName(node.node);
}

std::string_view name(Outcome outcome) {
    switch (outcome) {
        case Outcome::Runs:
            return "runs";
        case Outcome::Kept:
            return "kept";
        case Outcome::Skipped:
            return "skipped";
        case Outcome::Culled:
            return "culled";
        case Outcome::Output:
            break;
    }
    return "output";
}

Outcome outcomeOf(const graph::Plan& plan, const graph::DrawnNode& node, const PassTimes& times) {
    if (node.node == graph::noIndex) return Outcome::Output;
    const graph::NodeState state = plan.nodes[node.node].state;
    if (state == graph::NodeState::Skipped) return Outcome::Skipped;
    if (state == graph::NodeState::Culled) return Outcome::Culled;
    const TimeSeries* series = times.find(plan.graph->nodeName(node.node));
    return series != nullptr && !series->ran ? Outcome::Kept : Outcome::Runs;
}

std::string timeOf(const graph::Plan& plan, const graph::DrawnNode& node, const PassTimes& times) {
    if (node.node == graph::noIndex) return "";
    const TimeSeries* series = times.find(plan.graph->nodeName(node.node));
    return series == nullptr ? "" : fmt::format("{:.2f} ms", series->medianGpuMs());
}

std::string typeOf(const graph::Plan& plan, const graph::DrawnNode& node) {
    return node.node == graph::noIndex ? "" : plan.graph->nodes[node.node].type->name;
}

void drawGraphPicture(const GraphPicture& picture) {
    Painter(picture).paint();
}

void drawLegend(const GraphPicture& picture) {
    const float step = ImGui::GetFontSize();
    ImVec2 place{picture.corner.x + step / 2, picture.corner.y + step / 2};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float width = ImGui::CalcTextSize("runs kept skipped culled").x + 5 * step;
    list.AddRectFilled(picture.corner, {picture.corner.x + width, picture.corner.y + 2 * step},
                       ImGui::GetColorU32(ImGuiCol_WindowBg, 0.85F), step / 3);
    for (const Outcome outcome : {Outcome::Runs, Outcome::Kept, Outcome::Skipped, Outcome::Culled}) {
        const std::string word(name(outcome));
        list.AddText(place, ImGui::GetColorU32(colorOf(outcome)), word.c_str());
        place.x += ImGui::CalcTextSize(word.c_str()).x + step;
    }
}

void drawOverview(const GraphPicture& picture) {
    const GraphView& view = picture.view;
    constexpr float mostWidth = 260, mostHeight = 110, margin = 8;
    const float scale =
        picture.unit * std::min(mostWidth / view.drawing.width, mostHeight / view.drawing.height);
    const ImVec2 corner{picture.corner.x + margin, picture.corner.y + view.paneHeight * picture.unit -
                                                       view.drawing.height * scale - margin};
    const auto at = [&](float x, float y) { return ImVec2{corner.x + x * scale, corner.y + y * scale}; };
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(corner, at(view.drawing.width, view.drawing.height), true);
    list.AddRectFilled(corner, at(view.drawing.width, view.drawing.height),
                       ImGui::GetColorU32(ImGuiCol_PopupBg));
    for (const graph::DrawnNode& node : view.drawing.nodes) {
        const ImVec2 first = at(node.corner.x, node.corner.y);
        const ImVec2 last = at(node.corner.x + node.width, node.corner.y + node.height);
        list.AddRectFilled(first, {std::max(last.x, first.x + 1), std::max(last.y, first.y + 1)},
                           ImGui::GetColorU32(colorOf(outcomeOf(picture.plan, node, picture.times))));
    }
    list.AddRect(at(view.left, view.top),
                 at(view.left + view.paneWidth / view.zoom, view.top + view.paneHeight / view.zoom),
                 ImGui::GetColorU32(ImGuiCol_Text));
    list.AddRect(corner, at(view.drawing.width, view.drawing.height), ImGui::GetColorU32(ImGuiCol_Border));
    list.PopClipRect();
}

}  // namespace nephrite::view
