// Combinations of values, and patterns.
#include "pareto/points.h"

#include <fnmatch.h>

#include <algorithm>

#include "pareto/combinations.h"

namespace nephrite::pareto {
namespace {

bool hasAll(const SuiteScene& scene, const std::vector<truth::Mode>& modes) {
    return std::all_of(modes.begin(), modes.end(),
                       [&](truth::Mode mode) { return scene.find(mode) != nullptr; });
}

void append(std::vector<Point>& points, std::vector<Point> more) {
    points.insert(points.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

std::vector<std::string> Point::settingTexts() const {
    std::vector<std::string> texts;
    for (const Setting& setting : settings) texts.push_back(setting.text());
    return texts;
}

std::vector<Point> pointsOf(const Method& method) {
    std::vector<std::size_t> lengths;
    for (const Variation& variation : method.variations) lengths.push_back(variation.size());
    std::vector<Point> points;
    for (const std::vector<std::size_t>& choice : combinations(lengths)) {
        Point& point = points.emplace_back(Point{&method, method.name, {}, method.settings, points.empty()});
        for (std::size_t i = 0; i < choice.size(); ++i) {
            const Setting& setting = method.variations[i][choice[i]];
            point.name += " " + setting.text();
            point.parameters.emplace_back(setting.parameter, setting.value);
            point.settings.push_back(setting);
        }
    }
    return points;
}

Selection::Selection(std::string_view pattern) : pattern_(pattern) {
    if (pattern_.find('/') == std::string::npos) pattern_ += pattern_.empty() ? "*/*" : "/*";
}

bool Selection::has(const SuiteScene& scene, const Method& method) const {
    const std::string name = scene.name + "/" + method.name;
    return fnmatch(pattern_.c_str(), name.c_str(), FNM_PATHNAME | FNM_NOESCAPE) == 0;
}

std::vector<Point> pointsOf(const Suite& suite, const SuiteScene& scene, const Selection& selection) {
    std::vector<Point> points;
    bool isTimed = false;
    for (const Method& method : suite.methods) {
        if (method.name == suite.baseline || !selection.has(scene, method)) continue;
        if (!method.isTimed() && !hasAll(scene, method.references)) continue;
        isTimed = isTimed || method.isTimed();
        append(points, pointsOf(method));
    }
    const Method* baseline = suite.find(suite.baseline);
    if (baseline == nullptr || !(isTimed || selection.has(scene, *baseline))) return points;
    std::vector<Point> all = pointsOf(*baseline);
    append(all, std::move(points));
    return all;
}

bool needs(const std::vector<Point>& points, truth::Mode reference) {
    return std::any_of(points.begin(), points.end(), [reference](const Point& point) {
        const auto& sum = point.method->references;
        const auto& against = point.method->against;
        return std::find(sum.begin(), sum.end(), reference) != sum.end() ||
               std::any_of(against.begin(), against.end(),
                           [reference](const ComparedPort& port) { return port.reference == reference; });
    });
}

}  // namespace nephrite::pareto
