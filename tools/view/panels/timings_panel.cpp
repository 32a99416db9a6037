// Times of each pass as bars, with what they were lately.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "view/panels/panels.h"
#include "view/panels/widgets.h"
#include "view/style.h"
#include "view/viewer.h"

namespace nephrite::view {
namespace {

void bar(float value, float most, const ImVec4& color) {
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = ImGui::GetTextLineHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float part = most > 0 ? std::clamp(value / most, 0.0F, 1.0F) : 0;
    list.AddRectFilled(corner, {corner.x + width, corner.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg));
    list.AddRectFilled(corner, {corner.x + width * part, corner.y + height}, ImGui::GetColorU32(color));
    const std::string text = fmt::format("{:.{}f}", value, value < 0.1F ? 3 : 2);
    list.AddText({corner.x + 4, corner.y}, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    ImGui::Dummy({width, height});
}

void history(const char* id, const std::vector<float>& values, const ImVec4& color, float height) {
    ImGui::PushStyleColor(ImGuiCol_PlotLines, color);
    const float most = values.empty() ? 1 : *std::max_element(values.begin(), values.end());
    // ImGui 1.86 takes a width below 0 as it is, and draws nothing.
    const ImVec2 size{std::max(ImGui::GetContentRegionAvail().x, 1.0F), height};
    ImGui::PlotLines(id, values.data(), static_cast<int>(values.size()), 0, nullptr, 0, std::max(most, 1e-3F),
                     size);
    ImGui::PopStyleColor();
}

void drawFrame(const PassTimes& times) {
    const runtime::FrameTimes& last = times.last();
    double gpu = 0;
    for (const runtime::PassTime& pass : last.passes) gpu += pass.gpuMs;
    ImGui::Text("frame %.2f ms", last.wallMs);
    coloredText(color::gpu, fmt::format("passes {:.2f} ms", gpu));
    coloredText(color::cpu, fmt::format("recording {:.2f} ms", last.recordMs));
    coloredText(color::quiet, fmt::format("submit, wait {:.2f} ms", last.waitMs));
    history("##frames", times.wallMs(), color::changed, ImGui::GetContentRegionAvail().y);
    explainItem(fmt::format("the last {} frames", times.wallMs().size()));
}

void drawPass(Viewer& viewer, const std::string& name, float mostGpu, float mostCpu) {
    const TimeSeries& series = viewer.bench().times().of(name);
    ImGui::PushID(name.c_str());
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    coloredText(series.ran ? ImGui::GetStyleColorVec4(ImGuiCol_Text) : color::quiet, name);
    explainItem(series.ran ? "ran in the last frame" : "kept: nothing it reads had changed");
    ImGui::TableNextColumn();
    bar(series.medianGpuMs(), mostGpu, color::gpu);
    explainItem("GPU, ms: the median of the frames in which it ran");
    ImGui::TableNextColumn();
    bar(series.cpuMs.back(), mostCpu, color::cpu);
    explainItem("recording its commands on the CPU, ms, in the last frame");
    ImGui::TableNextColumn();
    history("##gpu", series.gpuMs, color::gpu, ImGui::GetTextLineHeight());
    ImGui::TableNextColumn();
    history("##cpu", series.cpuMs, color::cpu, ImGui::GetTextLineHeight());
    ImGui::PopID();
}

void drawPasses(Viewer& viewer) {
    const PassTimes& times = viewer.bench().times();
    float mostGpu = 0;
    float mostCpu = 0;
    for (const std::string& pass : times.passes()) {
        mostGpu = std::max(mostGpu, times.of(pass).medianGpuMs());
        mostCpu = std::max(mostCpu, times.of(pass).cpuMs.back());
    }
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersInnerV |
                                      ImGuiTableFlags_Resizable | ImGuiTableFlags_SizingStretchSame;
    if (!ImGui::BeginTable("passes", 5, flags)) return;
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("pass", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize() * 11);
    ImGui::TableSetupColumn("GPU ms");
    ImGui::TableSetupColumn("CPU ms");
    ImGui::TableSetupColumn("GPU, last frames");
    ImGui::TableSetupColumn("CPU, last frames");
    ImGui::TableHeadersRow();
    for (const std::string& pass : times.passes()) drawPass(viewer, pass, mostGpu, mostCpu);
    ImGui::EndTable();
}

}  // namespace

void drawTimings(Viewer& viewer) {
    if (viewer.bench().times().frames() == 0) return;
    if (ImGui::BeginChild("frame", {ImGui::GetFontSize() * 14, 0})) drawFrame(viewer.bench().times());
    ImGui::EndChild();
    ImGui::SameLine();
    if (ImGui::BeginChild("table")) drawPasses(viewer);
    ImGui::EndChild();
}

}  // namespace nephrite::view
