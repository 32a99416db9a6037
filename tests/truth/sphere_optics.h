// A point light and a ball of glass by geometrical optics in the plane: what light reaches where, following
// rays or finding all of Fermat's paths. It shares nothing with the references but Fresnel's formulas.
//
// The ball is at the origin and the light on the x axis. A place is (x, rho), rho its distance from that
// axis. A ray is named by the angle at which it leaves the light, and by how often it was reflected inside.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <vector>

#include "scattering/fresnel.h"
#include "support.h"

namespace nephrite::truth::test {

struct GlassBall {
    double radius = 10;  ///< mm
    double eta = 1.5;
    double light = 25;         ///< x of the light, mm, outside; it shines with 1 W/sr
    double extinction = 0.02;  ///< 1/mm
    int reflections = 4;       ///< inner ones that are followed

    /// A ray between two reflections, or between the entry and the first.
    struct Way {
        glm::dvec2 start{0, 0};
        glm::dvec2 direction{1, 0};
        double length = 0;  ///< to the boundary, mm
        double power = 0;   ///< at the start, over what left the light
    };
    double greatestAngle() const { return std::asin(radius / light); }

    Way entering(double angle) const {
        const glm::dvec2 outside{-std::cos(angle), std::sin(angle)};
        const double across = light * std::sin(angle);
        const double along = light * std::cos(angle) - std::sqrt(radius * radius - across * across);
        Way way;
        way.start = glm::dvec2(light, 0) + along * outside;
        const glm::dvec2 normal = way.start / radius;
        const double cosine = -glm::dot(outside, normal);
        const double inside = std::sqrt(1 - (1 - cosine * cosine) / (eta * eta));
        way.direction = outside / eta + (cosine / eta - inside) * normal;
        way.length = 2 * radius * inside;
        way.power = 1 - scattering::reflectanceFromOutside(cosine, eta);
        return way;
    }
    Way reflected(Way way) const {
        way.start += way.length * way.direction;
        const glm::dvec2 normal = way.start / radius;
        way.direction -= 2 * glm::dot(way.direction, normal) * normal;
        way.power *= std::exp(-extinction * way.length) *
                     scattering::reflectanceFromInside(way.length / (2 * radius), eta);
        return way;
    }

    /// Power that the medium takes from the light, W: all reflections summed as a geometric series.
    double takenPower() const {
        constexpr int steps = 20000;
        double sum = 0;
        for (int i = 0; i < steps; ++i) {
            const double angle = greatestAngle() * (i + 0.5) / steps;
            const Way way = entering(angle);
            const double through = std::exp(-extinction * way.length);
            const double kept = scattering::reflectanceFromInside(way.length / (2 * radius), eta);
            sum += 2 * std::numbers::pi * std::sin(angle) * way.power * (1 - through) / (1 - kept * through);
        }
        return sum * greatestAngle() / steps;
    }

    Way way(double angle, int reflection) const {
        Way way = entering(angle);
        for (int i = 0; i < reflection; ++i) way = reflected(way);
        return way;
    }
};

/// Light at a place.
struct GlassArrival {
    double irradiance = 0;  ///< across the direction, 1/mm^2
    glm::dvec2 direction{1, 0};
};

/// Every ray through a place, by bisection between rays that pass it on either side.
class GlassPaths {
  public:
    explicit GlassPaths(const GlassBall& ball) : ball_(ball) {
        for (int reflection = 0; reflection <= ball.reflections; ++reflection)
            for (int i = 0; i <= steps; ++i) ways_.push_back(ball.way(angleAt(i), reflection));
    }

    /// The place must lie off the axis.
    std::vector<GlassArrival> arrivals(const glm::dvec2& place) const {
        std::vector<GlassArrival> found;
        auto way = ways_.begin();
        for (int reflection = 0; reflection <= ball_.reflections; ++reflection, ++way)
            for (int i = 0; i < steps; ++i, ++way)
                if (miss(way[0], place) * miss(way[1], place) < 0)
                    addArrival(place, between(angleAt(i), angleAt(i + 1), reflection, place), reflection,
                               found);
        return found;
    }

  private:
    static constexpr int steps = 800;

    /// Even steps in the sine of a parameter: close together where rays graze the ball.
    double angleAt(int step) const {
        const double sine = std::sin(std::numbers::pi * (double{1} * step / steps - 0.5));
        return (1 - 1e-9) * ball_.greatestAngle() * sine;
    }
    /// How far beside the place a ray passes, with a sign, mm.
    static double miss(const GlassBall::Way& way, const glm::dvec2& place) {
        const glm::dvec2 offset = place - way.start;
        return way.direction.x * offset.y - way.direction.y * offset.x;
    }
    double between(double low, double high, int reflection, const glm::dvec2& place) const {
        const double missAtLow = miss(ball_.way(low, reflection), place);
        for (int i = 0; i < 45; ++i) {
            const double middle = (low + high) / 2;
            (miss(ball_.way(middle, reflection), place) * missAtLow > 0 ? low : high) = middle;
        }
        return (low + high) / 2;
    }
    /// The rays within a small angle and azimuth cross the product of rho d(azimuth) and of how far they pass
    /// beside each other.
    void addArrival(const glm::dvec2& place, double angle, int reflection,
                    std::vector<GlassArrival>& found) const {
        const GlassBall::Way way = ball_.way(angle, reflection);
        const double along = glm::dot(way.direction, place - way.start);
        if (along < 0 || along > way.length) return;
        const double turn = std::min(1e-7, (ball_.greatestAngle() - std::abs(angle)) / 2);
        const double apart = (miss(ball_.way(angle + turn, reflection), place) -
                              miss(ball_.way(angle - turn, reflection), place)) /
                             (2 * turn);
        found.push_back(
            {way.power * std::exp(-ball_.extinction * along) * std::abs(std::sin(angle) / (place.y * apart)),
             way.direction});
    }

    GlassBall ball_;
    std::vector<GlassBall::Way> ways_;  ///< reflection by reflection
};

/// The ball as a scene, of these layers' text.
inline std::string glassScene(const GlassBall& ball, const std::string& layers, double g = 0) {
    return "{" + anyCamera +
           R"json(, "lights": [{"type": "point", "intensity": [1, 1, 1], "position": [)json" +
           std::to_string(ball.light) +
           R"json(, 0, 0]}], "objects": [{"mesh": {"procedural": "sphere", "radius": )json" +
           std::to_string(ball.radius) + R"json(}, "material": )json" + material(layers, ball.eta, g) + "}]}";
}

}  // namespace nephrite::truth::test
