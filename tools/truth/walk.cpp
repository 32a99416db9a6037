// One path, followed until it leaves the scene, is absorbed or loses the roulette.
#include "truth/walk.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "scattering/fresnel.h"
#include "scattering/phase.h"
#include "truth/boundary.h"
#include "truth/connection.h"

namespace nephrite::truth {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The direction at an angle of the given cosine around another, by chance which.
glm::dvec3 turned(const glm::dvec3& direction, double cosine, scattering::Random& random) {
    const double azimuth = 2 * std::numbers::pi * random.uniform();
    const double sine = std::sqrt(std::max(0.0, (1 - cosine) * (1 + cosine)));
    const glm::dvec3 helper = std::abs(direction.x) < 0.5 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0};
    const glm::dvec3 across = glm::normalize(glm::cross(direction, helper));
    const glm::dvec3 other = glm::cross(direction, across);
    return glm::normalize(cosine * direction +
                          sine * (std::cos(azimuth) * across + std::sin(azimuth) * other));
}

class Walk {
  public:
    Walk(const World& world, int channel, Scatterings scatterings, scattering::Random& random,
         const FluenceMap* unconnected)
        : world_(world),
          channel_(channel),
          scatterings_(scatterings),
          random_(random),
          unconnected_(unconnected) {}

    ScatteredRadiance from(const SurfacePoint& seen, const glm::dvec3& view) {
        direction_ = view;
        const Facing side = facing(seen, view);
        const double eta = world_.materialOf(seen.object).eta;
        weight_ = 1 - scattering::reflectanceFromOutside(side.cosine, eta);
        enter(seen, side, eta);
        while (isAlive() && survivesRoulette()) isInside_ ? moveInside() : moveOutside();
        return found_;
    }

  private:
    bool isAlive() const { return weight_ > 0; }
    void end() { weight_ = 0; }

    /// Weak paths, and paths that only bounce between boundaries, go on by chance.
    bool survivesRoulette() {
        constexpr double weak = 0.1;
        constexpr std::uint32_t manyCrossings = 32;
        constexpr double goOn = 0.8;
        if (crossings_ > manyCrossings) {
            if (!(random_.uniform() < goOn)) return false;
            weight_ /= goOn;
        }
        if (weight_ >= weak * firstWeight_) return true;
        if (!(random_.uniform() < 0.5)) return false;
        weight_ *= 2;
        return true;
    }

    void enter(const SurfacePoint& point, const Facing& side, double eta) {
        const double cosine = scattering::refractedCosineInside(side.cosine, eta);
        weight_ /= eta * eta;
        if (firstWeight_ == 0) firstWeight_ = weight_;
        direction_ = refract(direction_, side, cosine, eta);
        position_ = leave(point.position, -side.facet, world_.geometry().surfaceOffset());
        inside_ = {point.object, glm::dot(side.facet, point.facetNormal) > 0 ? 1.0 : -1.0};
        isInside_ = true;
    }

    void moveInside() {
        const Ray ray{position_, direction_};
        const auto boundary = world_.wayOut(ray, inside_, infinity);
        const double length = boundary ? boundary->distance : infinity;
        const auto collision = collideWithin(ray, length);
        if (collision)
            scatter(*collision);
        else if (!boundary)
            leaveScene();
        else if (boundary->object != inside_.object)
            end();
        else
            meetFromInside(*boundary);
    }

    /// Of an open mesh the medium ends with the scene.
    std::optional<Collision> collideWithin(const Ray& ray, double length) {
        const scene::EnclosingSphere& bounds = world_.geometry().bounds();
        const double farthest = glm::distance(position_, bounds.center) + bounds.radius;
        return world_.collide(ray, std::min(length, farthest), inside_.object, channel_, random_);
    }

    void scatter(const Collision& collision) {
        if (scatterings_ == Scatterings::One && count_ == 1) return end();
        position_ += collision.distance * direction_;
        weight_ *= collision.albedo;
        ++count_;
        if (!isAlive()) return;
        const double g = world_.materialOf(inside_.object).g;
        for (const scene::LightDescription& light : world_.lights()) {
            const double intensity = light.intensity[channel_];
            if (!(intensity > 0)) continue;
            const Arrival arrival = connect(world_, light.position, position_, inside_, channel_, random_);
            if (arrival.irradiance > 0)
                add(intensity * arrival.irradiance *
                    scattering::henyeyGreenstein(-glm::dot(arrival.direction, direction_), g));
        }
        if (unconnected_ != nullptr)
            add(unconnected_->inscattered(position_, inside_.object, channel_, direction_));
        direction_ = turned(direction_, scattering::sampleHenyeyGreenstein(g, random_.uniform()), random_);
        if (scatterings_ == Scatterings::One && !world_.hasEnvironment()) end();
    }

    void meetFromInside(const SurfacePoint& point) {
        ++crossings_;
        const Facing side = facing(point, direction_);
        const double eta = world_.materialOf(inside_.object).eta;
        const double offset = world_.geometry().surfaceOffset();
        if (random_.uniform() < scattering::reflectanceFromInside(side.cosine, eta)) {
            direction_ = reflect(direction_, side);
            position_ = leave(point.position, side.facet, offset);
            return;
        }
        const double cosine = scattering::refractedCosineOutside(side.cosine, eta);
        direction_ = refract(direction_, side, cosine, 1 / eta);
        position_ = leave(point.position, -side.facet, offset);
        weight_ *= eta * eta;
        isInside_ = false;
    }

    void moveOutside() {
        const auto boundary = world_.wayIn({position_, direction_}, infinity);
        if (!boundary) return leaveScene();
        const Material& material = world_.materialOf(boundary->object);
        if (!material.translucent()) return end();
        ++crossings_;
        const Facing side = facing(*boundary, direction_);
        if (random_.uniform() < scattering::reflectanceFromOutside(side.cosine, material.eta)) {
            direction_ = reflect(direction_, side);
            position_ = leave(boundary->position, side.facet, world_.geometry().surfaceOffset());
            return;
        }
        enter(*boundary, side, material.eta);
    }

    void leaveScene() {
        if (count_ > 0 && world_.hasEnvironment()) add(world_.environment(direction_)[channel_]);
        end();
    }

    void add(double radiance) { (count_ == 1 ? found_.single : found_.multiple) += weight_ * radiance; }

    const World& world_;
    int channel_;
    Scatterings scatterings_;
    scattering::Random& random_;
    const FluenceMap* unconnected_;

    ScatteredRadiance found_;
    glm::dvec3 position_{0, 0, 0};
    glm::dvec3 direction_{0, 0, 1};
    Inside inside_;
    bool isInside_ = false;
    double weight_ = 0;
    double firstWeight_ = 0;
    std::uint32_t count_ = 0;      ///< collisions so far
    std::uint32_t crossings_ = 0;  ///< boundaries met since the path began
};

}  // namespace

ScatteredRadiance sampleRadiance(const World& world, const SurfacePoint& seen, const glm::dvec3& view,
                                 int channel, Scatterings scatterings, scattering::Random& random,
                                 const FluenceMap* unconnected) {
    return Walk(world, channel, scatterings, random, unconnected).from(seen, view);
}

}  // namespace nephrite::truth
