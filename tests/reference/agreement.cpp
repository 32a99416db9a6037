// How well an image of the renderer agrees with the values it should have.
#include "reference/agreement.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/common.hpp>
#include <limits>

namespace nephrite::reference {
namespace {

double relativeError(double rendered, double expected, double floor) {
    const double difference = std::abs(rendered - expected);
    if (difference == 0) return 0;
    const double scale = std::max(std::abs(expected), floor);
    return std::isfinite(difference) ? difference / scale : std::numeric_limits<double>::infinity();
}

bool isFinite(const glm::dvec3& value) {
    return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z);
}

std::string toText(const glm::dvec3& value) {
    return fmt::format("({:.9g}, {:.9g}, {:.9g})", value.x, value.y, value.z);
}

}  // namespace

void Agreement::add(glm::ivec2 pixel, const glm::dvec3& rendered, const glm::dvec3& expected) {
    pairs_.push_back({pixel, rendered, expected});
}

glm::dvec3 Agreement::floors() const {
    glm::dvec3 sum(0);
    for (const Pair& pair : pairs_) sum += glm::abs(pair.expected);
    return glm::max(ofMean_ * sum / std::max(1.0, static_cast<double>(pairs_.size())), glm::dvec3(smallest_));
}

Agreement::Result Agreement::measure(double tolerance) const {
    const glm::dvec3 floor = floors();
    Result result;
    result.pixels = pairs_.size();
    for (const Pair& pair : pairs_) {
        double error = 0;
        for (int channel = 0; channel < 3; ++channel)
            error = std::max(error,
                             relativeError(pair.rendered[channel], pair.expected[channel], floor[channel]));
        result.within += error <= tolerance ? 1 : 0;
        result.nonFinite += isFinite(pair.rendered) ? 0 : 1;
        result.lit = result.lit || pair.expected != glm::dvec3(0);
        if (error <= result.worstError) continue;
        result.worstError = error;
        result.worst = fmt::format("pixel ({}, {}): rendered {}, expected {}", pair.pixel.x, pair.pixel.y,
                                   toText(pair.rendered), toText(pair.expected));
    }
    return result;
}

std::string Agreement::Result::summary() const {
    return fmt::format("{} of {} pixels within tolerance ({:.3f} %), {} not finite; worst error {:.3g} at {}",
                       within, pixels, 100 * fraction(), nonFinite, worstError,
                       worst.empty() ? "no pixel" : worst);
}

}  // namespace nephrite::reference
