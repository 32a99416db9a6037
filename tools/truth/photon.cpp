// Boundaries reflect and refract by chance; the media on the way weaken the photon and take points from it.
#include "truth/photon.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "scattering/fresnel.h"
#include "truth/boundary.h"
#include "truth/connection.h"
#include "truth/way_points.h"

namespace nephrite::truth {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What a photon has met: nothing yet, index-matched boundaries alone, a refraction at the first surface
/// alone, or anything else.
enum class History { Fresh, Straight, Refracted, Other };

class Photon {
  public:
    Photon(const World& world, const Ray& ray, const glm::dvec3& power, scattering::Random& random,
           PhotonPoints& points)
        : world_(world),
          light_(ray.origin),
          firstPower_(strongest(power)),
          random_(random),
          points_(points),
          ray_(ray),
          power_(power) {}

    void follow(std::optional<std::uint32_t> object) {
        isInside_ = object.has_value();
        inside_ = {object.value_or(0), 1};
        while (crossesOn() && survives(power_)) isInside_ ? moveInside() : moveOutside();
    }

  private:
    void end() { power_ = glm::dvec3(0); }

    /// Weak light goes on by chance; multiplies what survives.
    bool survives(glm::dvec3& power) {
        constexpr double weak = 0.05;
        const double share = strongest(power) / firstPower_;
        if (share >= weak) return true;
        if (!(random_.uniform() * weak < share)) return false;
        power *= weak / share;
        return true;
    }

    /// Light that only bounces between boundaries goes on by chance.
    bool crossesOn() {
        constexpr std::uint32_t manyCrossings = 32;
        constexpr double goOn = 0.8;
        if (crossings_ <= manyCrossings) return true;
        power_ /= goOn;
        return random_.uniform() < goOn;
    }

    void moveOutside() {
        const auto boundary = world_.wayIn(ray_, infinity);
        if (!boundary || !world_.materialOf(boundary->object).translucent()) return end();
        const double eta = world_.materialOf(boundary->object).eta;
        const Facing side = facing(*boundary, ray_.direction);
        if (isReflected(scattering::reflectanceFromOutside(side.cosine, eta)))
            return reflectAt(*boundary, side);
        cross(eta, History::Refracted);
        inside_ = {boundary->object, glm::dot(side.facet, boundary->facetNormal) > 0 ? 1.0 : -1.0};
        isInside_ = true;
        refractAt(*boundary, side, scattering::refractedCosineInside(side.cosine, eta), eta);
    }

    void moveInside() {
        const auto boundary = world_.wayOut(ray_, inside_, infinity);
        // Of an open mesh the medium ends with the scene.
        const scene::EnclosingSphere& bounds = world_.geometry().bounds();
        const double farthest = glm::distance(ray_.origin, bounds.center) + bounds.radius;
        leavePoints(std::min(boundary ? boundary->distance : infinity, farthest));
        if (!boundary || boundary->object != inside_.object) return end();
        power_ *= transmittance(boundary->distance);
        const double eta = world_.materialOf(inside_.object).eta;
        const Facing side = facing(*boundary, ray_.direction);
        if (isReflected(scattering::reflectanceFromInside(side.cosine, eta)))
            return reflectAt(*boundary, side);
        cross(eta, History::Other);
        isInside_ = false;
        refractAt(*boundary, side, scattering::refractedCosineOutside(side.cosine, eta), 1 / eta);
    }

    /// By chance, and more often than light is: little of it stays near the objects otherwise.
    bool isReflected(double reflectance) {
        ++crossings_;
        if (reflectance <= 0 || reflectance >= 1) return reflectance >= 1;
        const double chance = std::clamp(reflectance, 0.2, 0.8);
        const bool reflected = random_.uniform() < chance;
        power_ *= reflected ? reflectance / chance : (1 - reflectance) / (1 - chance);
        return reflected;
    }

    /// What becomes of the history at a boundary that lets the photon through.
    void cross(double eta, History ifFresh) {
        if (eta != 1)
            history_ = history_ == History::Fresh ? ifFresh : History::Other;
        else if (history_ == History::Fresh)
            history_ = History::Straight;
    }

    void reflectAt(const SurfacePoint& point, const Facing& side) {
        history_ = History::Other;
        met_ = point;
        ray_ = {leave(point.position, side.facet, world_.geometry().surfaceOffset()),
                reflect(ray_.direction, side)};
    }
    void refractAt(const SurfacePoint& point, const Facing& side, double cosine, double ratio) {
        met_ = point;
        ray_ = {leave(point.position, -side.facet, world_.geometry().surfaceOffset()),
                refract(ray_.direction, side, cosine, ratio)};
    }

    glm::dvec3 transmittance(double length) {
        glm::dvec3 through;
        for (int c = 0; c < 3; ++c)
            through[c] = world_.transmittance(ray_, length, inside_.object, c, random_);
        return through;
    }

    void leavePoints(double length) {
        constexpr int count = 2;
        const bool isStraight = history_ == History::Fresh || history_ == History::Straight;
        if (isStraight || !(length > 0)) return;
        const WayPoints places(length, world_.materialOf(inside_.object).greatestExtinction);
        for (int i = 0; i < count; ++i) {
            const double place = places.sample(random_);
            glm::dvec3 power = power_ * transmittance(place);
            if (!survives(power)) continue;
            const FluencePoint point{met_.position + place * ray_.direction, ray_.direction,
                                     power / (count * places.density(place))};
            if (isConnected(point))
                points_.connected += strongest(point.fluence);
            else
                points_.byObject[inside_.object].push_back(point);
        }
    }

    bool isConnected(const FluencePoint& point) const {
        return history_ == History::Refracted &&
               isRefractedPath(world_, light_, met_, point.position, inside_);
    }

    const World& world_;
    glm::dvec3 light_;
    double firstPower_;
    scattering::Random& random_;
    PhotonPoints& points_;

    Ray ray_;
    glm::dvec3 power_;
    History history_ = History::Fresh;
    SurfacePoint met_;  ///< where the way begins; the ray starts beside it
    Inside inside_;
    bool isInside_ = false;
    std::uint32_t crossings_ = 0;  ///< boundaries met
};

}  // namespace

double strongest(const glm::dvec3& channels) {
    return std::max({channels.x, channels.y, channels.z});
}

void followPhoton(const World& world, const Ray& ray, const glm::dvec3& power,
                  std::optional<std::uint32_t> object, scattering::Random& random, PhotonPoints& points) {
    if (strongest(power) > 0) Photon(world, ray, power, random, points).follow(object);
}

}  // namespace nephrite::truth
