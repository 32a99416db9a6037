// What follows from the measurements.
#include "pareto/results.h"

#include <algorithm>
#include <cmath>

#include "pareto/front.h"

namespace nephrite::pareto {

double ComparisonResult::error() const {
    if (metrics.unbiased) {
        double worst = 0;
        // A channel in which the reference is black has no value.
        for (const double channel : metrics.unbiased->relRmse) worst = std::fmax(worst, channel);
        if (worst > 0) return worst;
    }
    return metrics.worstRelRmse();
}

void setRatios(std::vector<PointResult>& points, std::size_t baseline) {
    const std::vector<double> base = points[baseline].wallMs;
    for (PointResult& point : points) {
        if (!point.isTimed()) continue;
        std::vector<double> ratios;
        for (std::size_t round = 0; round < base.size(); ++round)
            ratios.push_back(point.wallMs[round] / base[round]);
        point.ratioToBaseline = runtime::timeStatistics(std::move(ratios)).median;
    }
}

void markFronts(SceneResult& scene) {
    for (const ReferenceResult& reference : scene.references) {
        std::vector<ComparisonResult*> comparisons;
        std::vector<Cost> costs;
        for (PointResult& point : scene.points) {
            if (!point.isTimed()) continue;
            const double time = runtime::timeStatistics(point.wallMs).median;
            for (ComparisonResult& comparison : point.comparisons) {
                if (comparison.reference != reference.mode) continue;
                comparisons.push_back(&comparison);
                costs.push_back({time, comparison.error()});
            }
        }
        const std::vector<bool> front = paretoFront(costs);
        for (std::size_t i = 0; i < front.size(); ++i) comparisons[i]->isOnFront = front[i];
    }
}

}  // namespace nephrite::pareto
