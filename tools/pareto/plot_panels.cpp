// Points, axes and labels.
#include "pareto/plot_panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "truth/reference_run.h"

namespace nephrite::pareto {
namespace {

/// A method's first point has its name, the others the values that differ.
std::string labelOf(const PointResult& point) {
    if (point.isFirst) return point.method;
    std::string label;
    for (const auto& [parameter, value] : point.parameters) label += (label.empty() ? "" : ", ") + value;
    return label;
}

std::vector<Mark> marksOf(const SceneResult& scene, truth::Mode reference) {
    std::vector<Mark> marks;
    std::vector<std::string> methods;
    for (const PointResult& point : scene.points) {
        if (methods.empty() || methods.back() != point.method) methods.push_back(point.method);
        const double time = runtime::timeStatistics(point.wallMs).median;
        for (const ComparisonResult& comparison : point.comparisons) {
            const double error = 100 * comparison.error();
            if (comparison.reference == reference && error > 0 && std::isfinite(error))
                marks.push_back({labelOf(point), methods.size(), error, time, comparison.isOnFront,
                                 LabelPlace::RightAbove});
        }
    }
    std::stable_sort(marks.begin(), marks.end(), [](const Mark& a, const Mark& b) {
        return std::tie(a.method, a.time) < std::tie(b.method, b.time);
    });
    return marks;
}

/// Around the values that are above 0, half a decade at least, with a tenth of that at either end.
Axis axisOf(const std::vector<Mark>& marks, double Mark::*value) {
    Axis axis{std::numeric_limits<double>::infinity(), 0};
    for (const Mark& mark : marks) {
        if (!(mark.*value > 0)) continue;
        axis.least = std::min(axis.least, mark.*value);
        axis.greatest = std::max(axis.greatest, mark.*value);
    }
    constexpr double fewestDecades = 0.5;
    const double decades = std::log10(axis.greatest / axis.least);
    const double more = std::max(fewestDecades - decades, 0.0);
    const double room = std::pow(10, more / 2 + 0.12 * (decades + more));
    return {axis.least / room, axis.greatest * room};
}

/// Where a value lies on an axis of `length` pixels.
double pixelOf(double value, const Axis& axis, double length) {
    return length * std::log(value / axis.least) / std::log(axis.greatest / axis.least);
}

void placeLabels(Panel& panel, const PanelMetrics& metrics) {
    std::vector<LabelledPoint> points;
    std::vector<Mark*> marks;
    for (Mark& mark : panel.marks) {
        if (!mark.isTimed()) continue;
        marks.push_back(&mark);
        points.push_back({pixelOf(mark.error, panel.errors, metrics.width),
                          pixelOf(mark.time, panel.times, metrics.height),
                          metrics.letterWidth * static_cast<double>(mark.label.size())});
    }
    const auto places = placeLabels(points, {metrics.width, metrics.height, metrics.lineHeight});
    for (std::size_t i = 0; i < places.size(); ++i) marks[i]->labelPlace = places[i];
}

}  // namespace

std::vector<double> Axis::tics() const {
    const double decades = std::log10(greatest / least);
    std::vector<double> digits{1};
    if (decades < 3.5) digits = {1, 3};
    if (decades < 1.8) digits = {1, 2, 5};
    std::vector<double> values;
    for (double decade = std::pow(10, std::floor(std::log10(least))); decade <= greatest; decade *= 10)
        for (const double digit : digits)
            if (digit * decade >= least && digit * decade <= greatest) values.push_back(digit * decade);
    return values;
}

std::vector<Panel> panelsOf(const SuiteResult& result, const PanelMetrics& metrics) {
    std::vector<Panel> panels;
    for (const SceneResult& scene : result.scenes) {
        for (const ReferenceResult& reference : scene.references) {
            Panel panel{fmt::format("{} against {}", scene.name, name(reference.mode)),
                        marksOf(scene, reference.mode),
                        {},
                        {}};
            if (std::none_of(panel.marks.begin(), panel.marks.end(),
                             [](const Mark& mark) { return mark.isTimed(); }))
                continue;
            panel.errors = axisOf(panel.marks, &Mark::error);
            panel.times = axisOf(panel.marks, &Mark::time);
            placeLabels(panel, metrics);
            panels.push_back(std::move(panel));
        }
    }
    return panels;
}

std::vector<std::pair<double, double>> frontStair(const Panel& panel) {
    std::vector<std::pair<double, double>> front;
    for (const Mark& mark : panel.marks)
        if (mark.isTimed() && mark.isOnFront) front.emplace_back(mark.error, mark.time);
    std::sort(front.begin(), front.end());
    std::vector<std::pair<double, double>> corners;
    double time = panel.times.greatest;
    for (const auto& point : front) {
        corners.emplace_back(point.first, time);
        corners.push_back(point);
        time = point.second;
    }
    if (!front.empty()) corners.emplace_back(panel.errors.greatest, time);
    return corners;
}

}  // namespace nephrite::pareto
