// Twist, bend and pulse: positions by formula, normals by the cofactor matrix of the same formula's Jacobian.
#include "scene/mesh/deformation.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

namespace nephrite::scene {
namespace {

struct Moved {
    glm::dvec3 position;
    glm::dvec3 normal;
};

/// The axis, its extent on the box, and where a point lies along it.
struct Frame {
    glm::dvec3 center;
    glm::dvec3 axis;
    double length = 1.0;
};

Frame frameOf(const Deformation& deformation, const Box& box) {
    const glm::dvec3 axis = glm::normalize(deformation.axis);
    const double length = glm::dot(glm::abs(axis), glm::dvec3(box.maximum) - glm::dvec3(box.minimum));
    return {0.5 * (glm::dvec3(box.minimum) + glm::dvec3(box.maximum)), axis, length > 0.0 ? length : 1.0};
}

/// Rodrigues' rotation of v about the unit axis.
glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& axis, double angle) {
    return std::cos(angle) * v + std::sin(angle) * glm::cross(axis, v) +
           (1.0 - std::cos(angle)) * glm::dot(axis, v) * axis;
}

/// The angle between the two ends at this time.
double swing(const Deformation& deformation, double seconds) {
    return glm::radians(deformation.degrees) * std::sin(glm::two_pi<double>() * seconds / deformation.period);
}

/// p' = R(k s) q, so J = R (I + k (a x q) a^T) and J^-T n = R (n - k a ((a x q).n)); det J = 1.
class Twist {
  public:
    Twist(const Deformation& deformation, const Frame& frame, double seconds)
        : axis_(frame.axis), anglePerLength_(swing(deformation, seconds) / frame.length) {}

    Moved operator()(const glm::dvec3& q, const glm::dvec3& n) const {
        const double angle = anglePerLength_ * glm::dot(q, axis_);
        const glm::dvec3 sheared = n - anglePerLength_ * glm::dot(glm::cross(axis_, q), n) * axis_;
        return {turned(q, axis_, angle), turned(sheared, axis_, angle)};
    }

  private:
    glm::dvec3 axis_;
    double anglePerLength_;
};

/// With x along `towards`, s along the axis and curvature k: x' = x cos(ks) + (1 - cos(ks))/k,
/// s' = (1/k - x) sin(ks). J is the rotation by ks times diag(1, 1 - kx, 1) for (x, s, rest).
class Bend {
  public:
    Bend(const Deformation& deformation, const Frame& frame, double seconds)
        : axis_(frame.axis), curvature_(swing(deformation, seconds) / frame.length) {
        const glm::dvec3 across = deformation.towards - glm::dot(deformation.towards, axis_) * axis_;
        towards_ = glm::normalize(across);
    }

    Moved operator()(const glm::dvec3& q, const glm::dvec3& n) const {
        const double s = glm::dot(q, axis_);
        const double x = glm::dot(q, towards_);
        const double angle = curvature_ * s;
        const glm::dvec3 tangent = std::cos(angle) * axis_ + std::sin(angle) * towards_;
        const glm::dvec3 inward = std::cos(angle) * towards_ - std::sin(angle) * axis_;
        // The arc's point, written with sinc so that it holds as the curvature goes to 0.
        const double half = 0.5 * angle;
        const double chord = s * sinc(half);
        const glm::dvec3 arc = chord * (std::cos(half) * axis_ + std::sin(half) * towards_);
        const double stretch = 1.0 - curvature_ * x;
        const glm::dvec3 rest = q - s * axis_ - x * towards_;
        const glm::dvec3 normalRest = n - glm::dot(n, axis_) * axis_ - glm::dot(n, towards_) * towards_;
        return {arc + x * inward + rest,
                stretch * (glm::dot(n, towards_) * inward + normalRest) + glm::dot(n, axis_) * tangent};
    }

  private:
    static double sinc(double angle) { return std::abs(angle) < 1e-8 ? 1.0 : std::sin(angle) / angle; }

    glm::dvec3 axis_;
    glm::dvec3 towards_;
    double curvature_;
};

/// r' = f(s) r, s' = s, so J^-T n = (n_r + (f n.a - f' r.n) a) / f.
class Pulse {
  public:
    Pulse(const Deformation& deformation, const Frame& frame, double seconds)
        : axis_(frame.axis),
          amount_(deformation.amount),
          phasePerLength_(glm::two_pi<double>() * deformation.waves / frame.length),
          phase_(-glm::two_pi<double>() * seconds / deformation.period) {}

    Moved operator()(const glm::dvec3& q, const glm::dvec3& n) const {
        const double s = glm::dot(q, axis_);
        const double angle = phasePerLength_ * s + phase_;
        const double width = 1.0 + amount_ * std::sin(angle);
        const double slope = amount_ * phasePerLength_ * std::cos(angle);
        const glm::dvec3 radial = q - s * axis_;
        const double along = glm::dot(n, axis_);
        return {width * radial + s * axis_,
                n - along * axis_ + (width * along - slope * glm::dot(radial, n)) * axis_};
    }

  private:
    glm::dvec3 axis_;
    double amount_;
    double phasePerLength_;
    double phase_;
};

template<typename Move>
void apply(const Move& move, const glm::dvec3& center, Pose& pose) {
    for (std::size_t i = 0; i < pose.positions.size(); ++i) {
        const Moved moved = move(glm::dvec3(pose.positions[i]) - center, glm::dvec3(pose.normals[i]));
        pose.positions[i] = glm::vec3(center + moved.position);
        const double length = glm::length(moved.normal);
        if (length > 0.0) pose.normals[i] = glm::vec3(moved.normal / length);
    }
}

}  // namespace

void deform(const Deformation& deformation, const Box& restBox, double seconds, Pose& pose) {
    const Frame frame = frameOf(deformation, restBox);
    switch (deformation.kind) {
        case DeformationKind::twist:
            apply(Twist(deformation, frame, seconds), frame.center, pose);
            return;
        case DeformationKind::bend:
            apply(Bend(deformation, frame, seconds), frame.center, pose);
            return;
        case DeformationKind::pulse:
            apply(Pulse(deformation, frame, seconds), frame.center, pose);
            return;
    }
}

}  // namespace nephrite::scene
