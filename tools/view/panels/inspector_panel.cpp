// The right column: which port is looked at, how it is made visible, its values under the cursor, a
// reference.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "view/panels/panels.h"
#include "view/panels/widgets.h"
#include "view/style.h"
#include "view/viewer.h"

namespace nephrite::view {
namespace {

constexpr const char* channelNames[] = {"colour", "R", "G", "B", "A", "luminance"};
constexpr const char* curveNames[] = {"clip at 1", "PBR neutral", "signed -1..1"};

/// The resource that the looked-at port has in the plan, or nullptr.
const graph::Resource* shownResource(const graph::Plan& plan) {
    for (const graph::RequestedOutput& output : plan.requested)
        if (output.name == graph::valuesName && output.resource != graph::noIndex)
            return &plan.resources[output.resource];
    return nullptr;
}

void look(Viewer& viewer, const PictureChoice& choice) {
    viewer.attempt([&] { viewer.bench().look(choice); });
}

void drawPort(Viewer& viewer, const graph::LinkedGraph& graph, graph::Index node, graph::Index port) {
    const graph::OutputPort& output = graph.nodes[node].type->outputs[port];
    const std::string name = graph.portName(node, port);
    const bool isBuffer = !output.bufferElement.empty();
    ImGui::BeginDisabled(isBuffer);
    PictureChoice choice = viewer.bench().choice();
    if (ImGui::Selectable(name.c_str(), choice.port == name)) {
        choice.port = name;
        look(viewer, choice);
    }
    ImGui::EndDisabled();
    const graph::Format format = graph.formats[graph.nodes[node].formats.first + port];
    explainItem(isBuffer ? fmt::format("{}\na buffer of {}: not a picture", output.doc, output.bufferElement)
                         : fmt::format("{}\n{}", output.doc, graph::info(format).name));
}

void drawPorts(Viewer& viewer) {
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo("##port", viewer.bench().choice().port.c_str(), ImGuiComboFlags_HeightLargest))
        return;
    ViewState& state = viewer.state();
    if (ImGui::IsWindowAppearing()) {
        state.portFilter.clear();
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##filter", "filter", &state.portFilter);
    const auto graph = viewer.bench().document().graph();
    for (graph::Index node = 0; node < graph->nodes.size(); ++node) {
        if (graph->nodes[node].role == graph::NodeRole::TileList) continue;
        for (graph::Index port = 0; port < graph->nodes[node].type->outputs.size(); ++port)
            if (graph->portName(node, port).find(state.portFilter) != std::string::npos)
                drawPort(viewer, *graph, node, port);
    }
    ImGui::EndCombo();
}

void drawFacts(const graph::Plan& plan) {
    const graph::Resource* resource = shownResource(plan);
    if (resource == nullptr) return coloredText(color::changed, "nothing computes it in this scene");
    std::string text = fmt::format("{} x {}  {}", resource->extent.width, resource->extent.height,
                                   graph::info(resource->format).name);
    if (resource->mips > 1) text += fmt::format("  {} levels", resource->mips);
    if (resource->layers > 1) text += fmt::format("  {} layers", resource->layers);
    coloredText(color::quiet, text);
}

bool sliderRow(const char* name, std::uint32_t& value, std::uint32_t count) {
    if (count < 2) return false;
    const std::uint32_t least = 0;
    const std::uint32_t greatest = count - 1;
    ImGui::SetNextItemWidth(-ImGui::GetFontSize() * 5);
    return ImGui::SliderScalar(name, ImGuiDataType_U32, &value, &least, &greatest, "%u",
                               ImGuiSliderFlags_AlwaysClamp);
}

template<std::size_t N>
bool choiceRow(const char* name, std::uint32_t& value, const char* const (&names)[N]) {
    auto index = static_cast<int>(value);
    ImGui::SetNextItemWidth(-ImGui::GetFontSize() * 5);
    if (!ImGui::Combo(name, &index, names, static_cast<int>(N))) return false;
    value = static_cast<std::uint32_t>(index);
    return true;
}

bool exposureRow(Viewer& viewer, double& exposure) {
    constexpr double least = 1e-6;
    constexpr double greatest = 1e6;
    ImGui::SetNextItemWidth(-ImGui::GetFontSize() * 8);
    const bool isChanged = ImGui::SliderScalar("##exposure", ImGuiDataType_Double, &exposure, &least,
                                               &greatest, "%.4g", ImGuiSliderFlags_Logarithmic);
    explainItem("factor before the curve");
    ImGui::SameLine();
    if (ImGui::Button("auto")) viewer.attempt([&] { viewer.bench().exposeAutomatically(); });
    explainItem("E: brings the 98th percentile of the luminance to 0.7");
    ImGui::SameLine();
    ImGui::TextUnformatted("exposure");
    return isChanged && exposure >= 0;
}

void drawLooks(Viewer& viewer) {
    PictureChoice choice = viewer.bench().choice();
    const graph::Resource* resource = shownResource(viewer.bench().session().plan());
    bool isChanged = exposureRow(viewer, choice.exposure);
    isChanged |= choiceRow("channel", choice.channel, channelNames);
    isChanged |= choiceRow("curve", choice.curve, curveNames);
    isChanged |= sliderRow("level", choice.level, resource == nullptr ? 1 : resource->mips);
    isChanged |= sliderRow("layer", choice.layer, resource == nullptr ? 1 : resource->layers);
    if (isChanged) look(viewer, choice);
    auto magnification = static_cast<float>(viewer.state().magnification.factor);
    ImGui::SetNextItemWidth(-ImGui::GetFontSize() * 5);
    if (ImGui::SliderFloat("magnify", &magnification, 1, 512, "%.3g x",
                           ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp))
        viewer.state().magnification.factor = magnification;
    explainItem("Ctrl + wheel over the picture; 0 fits it again");
}

}  // namespace

void drawInspector(Viewer& viewer) {
    if (beginPanel("inspector", viewer.layout().inspector)) {
        heading("Picture");
        drawPorts(viewer);
        drawFacts(viewer.bench().session().plan());
        drawLooks(viewer);
        heading("Under the cursor");
        drawMagnifier(viewer);
        heading("Reference");
        drawReference(viewer);
    }
    endPanel();
}

void drawReference(Viewer& viewer) {
    ViewState& state = viewer.state();
    PictureChoice choice = viewer.bench().choice();
    ImGui::SetNextItemWidth(-1);
    const bool isEntered = ImGui::InputTextWithHint(
        "##reference", "FILE.exr, then Enter", &state.referenceFile, ImGuiInputTextFlags_EnterReturnsTrue);
    if (isEntered) {
        choice.reference = state.referenceFile.empty() ? std::filesystem::path()
                                                       : std::filesystem::absolute(state.referenceFile);
        look(viewer, choice);
    }
    if (viewer.bench().choice().reference.empty()) return;
    if (ImGui::Checkbox("show the difference (D)", &choice.difference)) look(viewer, choice);
    ImGui::SameLine();
    if (ImGui::Button("close")) {
        choice.reference.clear();
        choice.difference = false;
        return look(viewer, choice);
    }
    const std::optional<image::ReferenceError> error = viewer.errorIfKnown();
    if (!error) return coloredText(color::quiet, "no values");
    if (!error->fault.empty()) return coloredText(color::changed, error->fault);
    ImGui::Text("relRMSE  %.4g %%", 100 * error->worstRelRmse);
    explainItem("of the worst channel, over pixels lit in the reference");
    ImGui::Text("R %.3g  G %.3g  B %.3g %%", 100 * error->relRmse[0], 100 * error->relRmse[1],
                100 * error->relRmse[2]);
    ImGui::Text("mean ratio  %.4g  %.4g  %.4g", error->meanRatio[0], error->meanRatio[1],
                error->meanRatio[2]);
    if (error->nonFinite > 0)
        coloredText(color::fault, fmt::format("{} pixels are not finite", error->nonFinite));
}

}  // namespace nephrite::view
