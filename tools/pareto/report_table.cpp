// Results as a table in Markdown.
#include <fmt/format.h>

#include <algorithm>

#include "pareto/report.h"
#include "truth/reference_run.h"

namespace nephrite::pareto {
namespace {

/// The first point of each method, in the order of the suite as far as the scenes tell.
std::vector<std::string> methodsOf(const SuiteResult& result) {
    std::vector<std::string> methods;
    for (const SceneResult& scene : result.scenes)
        for (const PointResult& point : scene.points)
            if (std::find(methods.begin(), methods.end(), point.method) == methods.end())
                methods.push_back(point.method);
    return methods;
}

const PointResult* firstOf(const SceneResult& scene, std::string_view method) {
    for (const PointResult& point : scene.points)
        if (point.method == method && point.isFirst) return &point;
    return nullptr;
}

const ComparisonResult* comparisonWith(const PointResult& point, truth::Mode reference) {
    for (const ComparisonResult& comparison : point.comparisons)
        if (comparison.reference == reference) return &comparison;
    return nullptr;
}

/// Three significant digits.
std::string percent(double part) {
    return part >= 10 ? fmt::format("{:.0f} %", 100 * part) : fmt::format("{:.3g} %", 100 * part);
}

std::string timeOf(const PointResult& point, const SuiteResult& result) {
    if (!point.isTimed()) return "";
    if (point.ratioToBaseline && point.method != result.baseline)
        return fmt::format("{:.2f} ×", *point.ratioToBaseline);
    return fmt::format("{:.3g} ms", runtime::timeStatistics(point.wallMs).median);
}

/// Error and time of a method; `reference` nullptr: only the time.
std::string cell(const PointResult* point, const ReferenceResult* reference, const SuiteResult& result) {
    if (point == nullptr) return "";
    const std::string time = timeOf(*point, result);
    if (reference == nullptr) return time;
    const ComparisonResult* comparison = comparisonWith(*point, reference->mode);
    if (comparison == nullptr) return "";
    std::string error = percent(comparison->error());
    if (comparison->isOnFront) error = "**" + error + "**";
    return time.empty() ? error : error + " · " + time;
}

std::string row(const SceneResult& scene, const ReferenceResult* reference, const SuiteResult& result,
                const std::vector<std::string>& methods) {
    const std::string against =
        reference == nullptr
            ? "–"
            : fmt::format("{}, ± {}", name(reference->mode),
                          percent(*std::max_element(reference->noise.begin(), reference->noise.end())));
    std::string text = fmt::format("| {} | {} |", scene.name, against);
    for (const std::string& method : methods)
        text += fmt::format(" {} |", cell(firstOf(scene, method), reference, result));
    return text + "\n";
}

std::string legend(const SuiteResult& result) {
    std::string text = fmt::format(
        "{} × {} pixels, {} interleaved frames each, {} ({}), commit {}. Error: relRMSE of the worst "
        "channel, "
        "without the reference's noise, which stands behind ±. Bold: on the front of Pareto.",
        result.width, result.height, result.frames, result.device, result.driver, result.commit);
    if (!result.baseline.empty())
        text += fmt::format(" ×: median ratio of a frame's time to that of `{}` in the same round.",
                            result.baseline);
    for (const SceneResult& scene : result.scenes)
        if (scene.bins > 1)
            text += fmt::format(" {}: means of {} × {} pixels.", scene.name, scene.bins, scene.bins);
    for (const LeftOutScene& scene : result.leftOut) text += fmt::format(" {}: left out.", scene.name);
    return text + "\n";
}

}  // namespace

std::string resultsAsTable(const SuiteResult& result) {
    const std::vector<std::string> methods = methodsOf(result);
    std::string text = "| scene | against |";
    std::string rule = "|---|---|";
    for (const std::string& method : methods) {
        text += fmt::format(" {} |", method);
        rule += "---|";
    }
    text += "\n" + rule + "\n";
    for (const SceneResult& scene : result.scenes) {
        for (const ReferenceResult& reference : scene.references)
            text += row(scene, &reference, result, methods);
        if (scene.references.empty()) text += row(scene, nullptr, result, methods);
    }
    return text + "\n" + legend(result);
}

}  // namespace nephrite::pareto
