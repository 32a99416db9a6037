// The exact dipole on a sphere under a point light, in polar coordinates around the point that is seen.
#include "reference/sphere_dipole.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "reference/integrate.h"
#include "reference/literal/fresnel.h"

namespace nephrite::reference {
namespace {

Dipole exactDipoleOf(const Medium& medium) {
    Dipole dipole = dipoleOf(medium);
    const double leaving = diffuseTransmittance(medium.eta) / (medium.eta * medium.eta);
    dipole.virtualDepth = dipole.realDepth * (1 + 4.0 / 3.0 * (2 - leaving) / leaving);
    return dipole;
}

double profile(const Dipole& dipole, double radius) {
    double sum = 0;
    for (const double z : {dipole.realDepth, dipole.virtualDepth}) {
        const double d = std::hypot(radius, z);
        sum += z * (1 + dipole.transport * d) * std::exp(-dipole.transport * d) / (d * d * d);
    }
    return dipole.albedo / (4 * std::numbers::pi) * sum;
}

/// F_t E of a point of the sphere, W/mm^2.
double enteringIrradiance(const LitSphere& sphere, const glm::dvec3& y, double eta) {
    const glm::dvec3 toLight = sphere.light - y;
    const double squared = glm::dot(toLight, toLight);
    const double cosine = glm::dot(toLight, y) / (sphere.radius * std::sqrt(squared));
    return cosine > 0 ? sphere.intensity * cosine / squared * (1 - fresnelReflectance(cosine, eta)) : 0;
}

}  // namespace

double diffuseTransmittance(double eta) {
    return integrate(0, 1, 4000, [&](double mu) { return 2 * mu * (1 - fresnelReflectance(mu, eta)); });
}

double dipoleExitance(const LitSphere& sphere, const Medium& medium, const glm::dvec3& x) {
    const Dipole dipole = exactDipoleOf(medium);
    const glm::dvec3 n = x / sphere.radius;
    const glm::dvec3 t =
        glm::normalize(glm::cross(n, std::abs(n.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 b = glm::cross(n, t);
    const double scale = dipole.realDepth;
    // Chords r = scale sinh(u) follow both the peak and the tail; on a sphere the area of a ring is 2 pi r
    // dr.
    return integrate(0, std::asinh(2 * sphere.radius / scale), 96, [&](double u) {
        const double r = scale * std::sinh(u);
        const double angle = 2 * std::asin(std::min(1.0, r / (2 * sphere.radius)));
        const double ring = integrate(0, 2 * std::numbers::pi, 64, [&](double azimuth) {
            const glm::dvec3 direction =
                std::cos(angle) * n + std::sin(angle) * (std::cos(azimuth) * t + std::sin(azimuth) * b);
            return enteringIrradiance(sphere, sphere.radius * direction, medium.eta);
        });
        return profile(dipole, r) * r * ring * scale * std::cosh(u);
    });
}

double diffuseRadiance(double exitance, double cosine, double eta) {
    return exitance / std::numbers::pi * (1 - fresnelReflectance(cosine, eta)) / diffuseTransmittance(eta);
}

}  // namespace nephrite::reference
