// The sum over all leaves, and what it shows.
#include "reference/geometric_sources.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "reference/integrate.h"
#include "reference/literal/fresnel.h"
#include "reference/sphere_dipole.h"

namespace nephrite::reference {
namespace {

constexpr double pi = std::numbers::pi;

double smoothstep(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

double henyeyGreenstein(double cosine, double g) {
    return (1 - g * g) / (4 * pi * std::pow(1 + g * g - 2 * g * cosine, 1.5));
}

/// What the formulas need of the medium.
struct Sources {
    explicit Sources(const Medium& medium, double totalReflectance)
        : eta(medium.eta), g(medium.g), reflectance(totalReflectance) {
        const double reduced = (1 - g) * medium.scattering;
        const double extinction = reduced + medium.absorption;
        freePath = 1 / extinction;
        transport = std::sqrt(3 * medium.absorption * extinction);
        absorbed = std::sqrt(medium.absorption / extinction);
        transmittance = diffuseTransmittance(eta);
        const double internal = 1 - transmittance / (eta * eta);
        boundary = 0.71045 * (1 + internal) / (1 - internal) * freePath;
        albedo = medium.scattering / (medium.scattering + medium.absorption);
        single = albedo * 2 * pi / (eta * eta) * integrate(0, 1, 20000, [&](double mu) {
                     const double c = refractedCosine(mu, eta);
                     return henyeyGreenstein(-c, g) * (1 - fresnelReflectance(mu, eta)) * mu / (1 + c);
                 });
        apart = smoothstep(0.15, 0.4, absorbed);
        fluenceShare = std::min(0.8 * absorbed, 0.12);
    }

    /// Of sources of light that entered at cosine c: what a plane reflects over what they send through it.
    double strength(double c) const {
        const double total = reflectance * (1 + 2 * absorbed) / (1 + 2 * c * absorbed);
        const double x = transport * boundary;
        const double flow = 1 + std::exp(-2 * x);
        const double fluence = x > 0 ? (1 - std::exp(-2 * x)) / x : 2;
        const double plane = 2 * pi * std::exp(-transport * freePath * c) *
                             ((1 - fluenceShare) * flow + fluenceShare * fluence);
        return std::max(total - apart * single * obliquity(c), 0.0) / plane;
    }
    static double obliquity(double c) { return 1.85 / (c + 0.85); }

    double eta;
    double g;
    double reflectance;
    double freePath = 0;       ///< mm
    double transport = 0;      ///< 1/mm
    double absorbed = 0;       ///< sqrt(1 - alpha')
    double transmittance = 0;  ///< T = 1 - F_dr,ext
    double boundary = 0;       ///< z_b, mm
    double albedo = 0;         ///< sigma_s/sigma_t
    double single = 0;
    double apart = 0;
    double fluenceShare = 0;
};

/// Vector irradiance per unit of flux from one leaf; the shares of fluence and of light that comes through
/// stand along the normal.
glm::dvec3 flowFrom(const FluxNode& leaf, const LitPoint& point, const Sources& sources) {
    const glm::dvec3 n = glm::normalize(leaf.normal);
    const glm::dvec3 arriving = glm::normalize(leaf.centre - point.light);
    const double mu = std::max(-glm::dot(arriving, n), 0.0);
    const double c = refractedCosine(mu, sources.eta);
    const glm::dvec3 travel = (arriving + n * mu) / sources.eta - n * c;
    const glm::dvec3 real = leaf.centre + travel * sources.freePath;
    const glm::dvec3 image = real + n * (2 * c * sources.freePath + 2 * sources.boundary);

    const auto distanceTo = [&](const glm::dvec3& source) {
        return std::max(glm::distance(point.position, source), 0.5 * sources.freePath);
    };
    const auto kernel = [&](double d) {
        const double s = sources.transport * d;
        return (1 + s) * std::exp(-s) / (d * d * d);
    };
    const auto potential = [&](double d) { return std::exp(-sources.transport * d) / d; };
    const double toReal = distanceTo(real);
    const double toImage = distanceTo(image);
    const glm::dvec3 taken = (point.position - image) * kernel(toImage);
    const glm::dvec3 flow = (point.position - real) * kernel(toReal) - taken;

    const glm::dvec3 along = point.position - leaf.centre;
    const double below = -glm::dot(along, n) / glm::length(along);
    const double opposite = std::clamp(-glm::dot(n, point.normal), 0.0, 1.0);
    const double fluence = (potential(toReal) - potential(toImage)) / sources.boundary;
    // What a slab as thick as the point is deep lets through, over what the source alone sends there.
    const double thick = std::max(-glm::dot(along, n), 0.0);
    const double throughSlab = 2 * std::sinh(sources.transport * (sources.freePath + sources.boundary)) /
                               std::sinh(sources.transport * (thick + 2 * sources.boundary)) *
                               std::exp(sources.transport * (thick - sources.freePath));
    const double more = sources.fluenceShare * (fluence - glm::dot(flow, point.normal)) +
                        opposite * smoothstep(0, 0.3, below) * std::min(throughSlab, 1.0) *
                            std::max(glm::dot(taken, point.normal), 0.0);
    const double inside = 1 - opposite * (1 - smoothstep(-0.2, 0.2, below));
    return inside * sources.strength(c) * (flow + more * point.normal);
}

/// g(c_o) over its mean: how much brighter multiply scattered light leaves at cosine mu than if evenly.
double shapeAt(double mu, const Sources& sources) {
    const double leaving = sources.transmittance / (sources.eta * sources.eta);
    const auto shape = [&](double at) {
        return 1 - 0.37 * std::pow(leaving, 4) * std::exp(-3.3 * refractedCosine(at, sources.eta));
    };
    const double mean = integrate(0, 1, 20000, [&](double at) {
        return 2 * at * (1 - fresnelReflectance(at, sources.eta)) * shape(at);
    });
    return shape(mu) * sources.transmittance / mean;
}

}  // namespace

double geometricRadiance(const LitPoint& point, std::span<const FluxNode> leaves, const Medium& medium,
                         double reflectance) {
    const Sources sources(medium, reflectance);
    glm::dvec3 flow(0);
    for (const FluxNode& leaf : leaves)
        if (leaf.variance >= 0) flow += point.intensity * leaf.flux * flowFrom(leaf, point, sources);

    const glm::dvec3 towards = point.light - point.position;
    const double squared = glm::dot(towards, towards);
    const double mu = std::max(glm::dot(point.normal, towards) / std::sqrt(squared), 0.0);
    const double view = glm::dot(point.normal, point.toViewer);
    const double c = refractedCosine(mu, sources.eta);
    const double viewInside = refractedCosine(view, sources.eta);
    const double entering =
        point.intensity * mu * point.visibility / squared * (1 - fresnelReflectance(mu, sources.eta));
    const double leaving = 1 - fresnelReflectance(view, sources.eta);

    // Directions of travel inside: of the light that enters, and backwards of the light that is seen.
    const glm::dvec3 inward = (mu / sources.eta - c) * point.normal - glm::normalize(towards) / sources.eta;
    const glm::dvec3 outward =
        (view / sources.eta - viewInside) * point.normal - point.toViewer / sources.eta;
    const double single = leaving / (sources.eta * sources.eta) * sources.albedo * entering *
                          henyeyGreenstein(-glm::dot(inward, outward), sources.g) / (c + viewInside);

    const double exitance =
        std::max(glm::dot(flow, point.normal) -
                     (1 - sources.apart) * entering * sources.single * Sources::obliquity(c),
                 0.0);
    const double drift =
        0.75 / pi * leaving / std::pow(sources.eta, 3) * glm::dot(flow, point.toViewer - view * point.normal);
    const double multiple = exitance / pi * leaving / sources.transmittance * shapeAt(view, sources);
    return std::max(multiple + drift, 0.0) + single;
}

}  // namespace nephrite::reference
