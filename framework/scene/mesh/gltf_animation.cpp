// STEP, LINEAR and CUBICSPLINE samplers as linear keys.
#include "scene/mesh/gltf_animation.h"

#include <fmt/format.h>

#include <cmath>
#include <span>

namespace nephrite::scene::gltf {
namespace {

constexpr std::size_t samplesPerSegment = 16;

enum class Interpolation { linear, step, cubicSpline };

Interpolation interpolationOf(const json::Value& sampler) {
    const std::optional<json::Value> value = sampler.find("interpolation");
    if (!value) return Interpolation::linear;
    constexpr std::string_view names[] = {"LINEAR", "STEP", "CUBICSPLINE"};
    const std::string name = text(*value, "an interpolation");
    for (std::size_t i = 0; i < std::size(names); ++i) {
        if (name == names[i]) return static_cast<Interpolation>(i);
    }
    fail(*value,
         fmt::format("expected LINEAR, STEP or CUBICSPLINE, found \"{}\"{}", name, suggestion(name, names)));
}

std::size_t accessorOf(const Document& document, const json::Value& sampler, std::string_view key) {
    const std::optional<std::size_t> accessor = findIndex(sampler, key, document.count("accessors"));
    if (!accessor) fail(sampler, fmt::format("a sampler needs \"{}\"", key));
    return *accessor;
}

std::vector<float> readTimes(const Document& document, const json::Value& sampler) {
    const std::vector<float> times =
        document.floats(accessorOf(document, sampler, "input"), "SCALAR", sampler);
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (times[i] < 0.0f || (i > 0 && times[i] <= times[i - 1])) {
            fail(sampler, fmt::format("key times must ascend from 0, found {} as time {}", times[i], i));
        }
    }
    return times;
}

/// Rotations are unit quaternions, also between the keys of a spline.
void normalize(std::span<float> quaternion) {
    double squared = 0.0;
    for (const float part : quaternion) squared += double{part} * part;
    if (!(squared > 0.0)) return;
    for (float& part : quaternion) part = static_cast<float>(part / std::sqrt(squared));
}

/// One segment of a Hermite spline: values and tangents at both ends (glTF 2.0, appendix C.5).
struct Segment {
    std::span<const float> from;
    std::span<const float> leaving;  ///< the tangent, per second
    std::span<const float> to;
    std::span<const float> arriving;
    float duration;

    float at(std::size_t k, float t) const {
        const float t2 = t * t;
        const float t3 = t2 * t;
        return (2 * t3 - 3 * t2 + 1) * from[k] + duration * (t3 - 2 * t2 + t) * leaving[k] +
               (-2 * t3 + 3 * t2) * to[k] + duration * (t3 - t2) * arriving[k];
    }
};

LinearKeys sampledSpline(const LinearKeys& spline) {
    const std::size_t n = spline.components;
    // Each key has an arriving tangent, a value and a leaving tangent.
    const auto part = [&](std::size_t key, std::size_t which) {
        return std::span<const float>(spline.values).subspan((3 * key + which) * n, n);
    };
    LinearKeys keys{{}, {}, n};
    for (std::size_t i = 0; i < spline.times.size(); ++i) {
        const bool last = i + 1 == spline.times.size();
        const float duration = last ? 0.0f : spline.times[i + 1] - spline.times[i];
        const std::size_t next = last ? i : i + 1;
        const Segment segment{part(i, 1), part(i, 2), part(next, 1), part(next, 0), duration};
        for (std::size_t s = 0; s < (last ? 1 : samplesPerSegment); ++s) {
            const float t = static_cast<float>(s) / samplesPerSegment;
            keys.times.push_back(spline.times[i] + t * duration);
            for (std::size_t k = 0; k < n; ++k) keys.values.push_back(segment.at(k, t));
        }
    }
    return keys;
}

LinearKeys stepped(const LinearKeys& steps) {
    const auto valueOf = [&](std::size_t key) {
        return std::span<const float>(steps.values).subspan(key * steps.components, steps.components);
    };
    LinearKeys keys{{}, {}, steps.components};
    for (std::size_t i = 0; i < steps.times.size(); ++i) {
        for (const std::size_t value : {i > 0 ? i - 1 : i, i}) {
            keys.times.push_back(steps.times[i]);
            keys.values.insert(keys.values.end(), valueOf(value).begin(), valueOf(value).end());
        }
    }
    return keys;
}

}  // namespace

LinearKeys readKeys(const Document& document, const json::Value& sampler, Path path, std::size_t weights) {
    const Interpolation interpolation = interpolationOf(sampler);
    constexpr std::string_view types[] = {"VEC3", "VEC4", "VEC3", "SCALAR"};
    const std::size_t components[] = {3, 4, 3, weights};
    LinearKeys keys;
    keys.components = components[static_cast<std::size_t>(path)];
    keys.times = readTimes(document, sampler);
    keys.values = document.floats(accessorOf(document, sampler, "output"),
                                  types[static_cast<std::size_t>(path)], sampler);
    const std::size_t perTime = keys.components * (interpolation == Interpolation::cubicSpline ? 3 : 1);
    if (keys.values.size() != keys.times.size() * perTime) {
        fail(sampler, fmt::format("{} key times need {} values, found {}", keys.times.size(),
                                  keys.times.size() * perTime, keys.values.size()));
    }
    if (interpolation == Interpolation::cubicSpline) keys = sampledSpline(keys);
    if (interpolation == Interpolation::step) keys = stepped(keys);
    if (path == Path::rotation) {
        for (std::size_t i = 0; i < keys.values.size(); i += 4)
            normalize(std::span(keys.values).subspan(i, 4));
    }
    return keys;
}

}  // namespace nephrite::scene::gltf
