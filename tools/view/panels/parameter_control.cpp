// From declarations to sliders.
#include "view/panels/parameter_control.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "view/panels/widgets.h"
#include "view/style.h"
#include "view/viewer.h"

namespace nephrite::view {
namespace {

using graph::Control;
using graph::ParameterType;

bool isWhole(const Control& control) {
    return control.type == ParameterType::Int || control.type == ParameterType::Uint;
}

std::string explanation(const Control& control) {
    std::string text = control.doc.empty() ? control.name : control.doc;
    if (control.range) text += fmt::format("\nrange: {:g} to {:g}", (*control.range)[0], (*control.range)[1]);
    text += fmt::format("\ndefault: {}", graph::valueText(control, control.defaultValue));
    if (control.specialized) text += "\ncompiled into the shader: another value takes a moment";
    return text;
}

/// How fast dragging changes a value without a range.
float dragSpeed(const Control& control, std::size_t component) {
    if (isWhole(control)) return 0.1F;
    return static_cast<float>(std::max(std::abs(control.value.components[component]), 0.01) * 0.01);
}

/// So many digits that the integers among its values are seen as such.
const char* numberFormat(const Control& control) {
    constexpr double fourDigits = 1e4;
    if (isWhole(control)) return "%.0f";
    double greatest =
        control.range ? std::max(std::abs((*control.range)[0]), std::abs((*control.range)[1])) : 0;
    if (!control.range)
        for (const double component : control.value.components)
            greatest = std::max(greatest, std::abs(component));
    return greatest < fourDigits ? "%.4g" : "%.6g";
}

/// Some components in one row. True if one was changed.
bool drawComponents(const Control& control, double* values, int count, std::size_t first) {
    const char* format = numberFormat(control);
    ImGui::SetNextItemWidth(-1);
    if (!control.range)
        return ImGui::DragScalarN("##value", ImGuiDataType_Double, values, count, dragSpeed(control, first),
                                  nullptr, nullptr, format);
    ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp;
    if (control.logarithmic) flags |= ImGuiSliderFlags_Logarithmic;
    const auto& [least, greatest] = *control.range;
    return ImGui::SliderScalarN("##value", ImGuiDataType_Double, values, count, &least, &greatest, format,
                                flags);
}

void send(Viewer& viewer, const Control& control, graph::ParameterValue value, bool starts) {
    if (isWhole(control))
        for (double& component : value.components) component = std::round(component);
    if (value == control.value) return;
    viewer.attempt([&] {
        viewer.bench().set(control.target, graph::valueText(control, value),
                           starts ? document::Gesture::Starts : document::Gesture::Continues);
    });
}

void drawBool(Viewer& viewer, const Control& control) {
    bool on = control.value.components[0] != 0;
    if (ImGui::Checkbox("##value", &on)) send(viewer, control, {{on ? 1.0 : 0.0}}, true);
}

/// At most four, and only as many as can be read.
std::size_t componentsPerRow() {
    const float widthOfOne = ImGui::GetFontSize() * 2.2F + ImGui::GetStyle().ItemInnerSpacing.x;
    return static_cast<std::size_t>(std::clamp(ImGui::GetContentRegionAvail().x / widthOfOne, 1.0F, 4.0F));
}

void drawNumbers(Viewer& viewer, const Control& control) {
    const std::size_t perRow = componentsPerRow();
    graph::ParameterValue value = control.value;
    for (std::size_t first = 0; first < value.components.size(); first += perRow) {
        const auto count = static_cast<int>(std::min(perRow, value.components.size() - first));
        ImGui::PushID(static_cast<int>(first));
        const bool isChanged = drawComponents(control, value.components.data() + first, count, first);
        const bool starts = ImGui::IsItemActivated();
        ImGui::PopID();
        explainItem(explanation(control));
        if (isChanged) send(viewer, control, value, starts);
    }
}

void drawReset(Viewer& viewer, const Control& control) {
    const bool differs = control.value != control.defaultValue;
    ImGui::BeginDisabled(!differs && control.boundTo.empty());
    if (ImGui::SmallButton("\xe2\x86\xba")) viewer.attempt([&] { viewer.bench().reset(control.target); });
    ImGui::EndDisabled();
    explainItem(fmt::format("back to {}", graph::valueText(control, control.defaultValue)));
}

}  // namespace

bool beginParameters(const char* name) {
    if (!ImGui::BeginTable(name, 3, ImGuiTableFlags_SizingFixedFit)) return false;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize() * 7.2F);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("reset", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize() * 1.6F);
    return true;
}

void endParameters() {
    ImGui::EndTable();
}

void drawParameter(Viewer& viewer, const Control& control) {
    ImGui::PushID(control.target.c_str());
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    const bool isChanged = viewer.bench().document().differsFromFile(control.target);
    coloredText(isChanged ? color::changed : ImGui::GetStyleColorVec4(ImGuiCol_Text), control.name);
    explainItem(explanation(control));
    ImGui::TableNextColumn();
    if (!control.boundTo.empty()) {
        coloredText(color::quiet, fmt::format("= {}", control.boundTo));
        explainItem("set by this parameter of the graph");
    } else if (control.type == ParameterType::Bool) {
        drawBool(viewer, control);
    } else {
        drawNumbers(viewer, control);
    }
    ImGui::TableNextColumn();
    drawReset(viewer, control);
    ImGui::PopID();
}

}  // namespace nephrite::view
