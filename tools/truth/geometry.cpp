// Placing the scene's meshes in the world, and asking Embree.
#include "truth/geometry.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "scene/scene_state.h"
#include "text/diagnostics.h"
#include "truth/placed_mesh.h"

namespace nephrite::truth {
namespace {

struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<RTCDeviceTy, ReleaseDevice>;
using EmbreeScene = std::unique_ptr<RTCSceneTy, ReleaseScene>;

/// Embree keeps a copy: its buffers must be padded, and what it finds is looked up here anyway.
void attach(RTCDevice device, RTCScene target, const PlacedMesh& mesh, std::uint32_t object) {
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), mesh.positions.size()));
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), mesh.indices.size() / 3));
    if (vertices == nullptr || indices == nullptr) throw std::bad_alloc();
    std::copy(mesh.positions.begin(), mesh.positions.end(), vertices);
    std::copy(mesh.indices.begin(), mesh.indices.end(), indices);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(target, geometry, object);
    rtcReleaseGeometry(geometry);
}

/// The part of a ray, as distances, that can meet anything.
struct Interval {
    double from;
    double to;
};

Interval within(const scene::EnclosingSphere& sphere, const Ray& ray, Interval interval) {
    if (sphere.empty()) return {1, 0};
    const double radius = 1.001 * sphere.radius;
    const glm::dvec3 toCenter = sphere.center - ray.origin;
    const double nearest = glm::dot(toCenter, ray.direction);
    const glm::dvec3 across = toCenter - nearest * ray.direction;
    const double squaredHalf = radius * radius - glm::dot(across, across);
    if (!(squaredHalf >= 0)) return {1, 0};
    const double half = std::sqrt(squaredHalf);
    return {std::max(interval.from, nearest - half), std::min(interval.to, nearest + half)};
}

RTCRayHit embreeRay(const glm::dvec3& origin, const glm::dvec3& direction, double length) {
    RTCRayHit query{};
    query.ray.org_x = static_cast<float>(origin.x);
    query.ray.org_y = static_cast<float>(origin.y);
    query.ray.org_z = static_cast<float>(origin.z);
    query.ray.dir_x = static_cast<float>(direction.x);
    query.ray.dir_y = static_cast<float>(direction.y);
    query.ray.dir_z = static_cast<float>(direction.z);
    query.ray.tfar = static_cast<float>(length);
    query.ray.mask = ~0U;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    return query;
}

}  // namespace

struct Geometry::State {
    std::vector<PlacedMesh> objects;
    Device device;
    EmbreeScene scene;
    scene::EnclosingSphere bounds;
    double surfaceOffset = 0;

    Triangle triangle(std::uint32_t object, std::uint32_t index) const {
        const PlacedMesh& mesh = objects[object];
        Triangle result;
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = mesh.indices[3 * std::size_t{index} + corner];
            result.positions[corner] = mesh.positions[vertex];
            result.normals[corner] = mesh.normals[vertex];
        }
        return result;
    }

    /// The point where a ray meets the plane of a triangle that Embree says it meets at `approximately`.
    SurfacePoint refine(const Ray& ray, double approximately, std::uint32_t object,
                        std::uint32_t index) const {
        const Triangle corners = triangle(object, index);
        const WeightGradients gradients = weightGradients(corners);
        SurfacePoint point;
        point.object = object;
        point.triangle = index;
        point.facetNormal = glm::normalize(glm::cross(corners.positions[1] - corners.positions[0],
                                                      corners.positions[2] - corners.positions[0]));
        const double slope = glm::dot(ray.direction, point.facetNormal);
        const double exact = glm::dot(corners.positions[0] - ray.origin, point.facetNormal) / slope;
        const bool isNear = std::abs(exact - approximately) <= 10 * surfaceOffset / std::abs(slope);
        point.distance = isNear && std::abs(slope) > 1e-6 ? exact : approximately;
        point.position = ray.origin + point.distance * ray.direction;
        const glm::dvec3 offset = point.position - corners.positions[0];
        const double second = std::clamp(glm::dot(gradients.second, offset), 0.0, 1.0);
        const double third = std::clamp(glm::dot(gradients.third, offset), 0.0, 1.0 - second);
        point.weights = {1 - second - third, second, third};
        point.normal = glm::normalize(interpolatedNormal(corners, point.weights));
        return point;
    }
};

Geometry::Geometry(const scene::Scene& scene, double seconds) : state_(std::make_unique<State>()) {
    const scene::Scene::State& source = scene.state();
    const scene::Moment moment = source.at(seconds);
    state_->bounds = moment.bounds;
    double largest = 0;
    for (std::size_t i = 0; i < source.description.objects.size(); ++i) {
        const std::uint32_t index = source.meshOfObject[i];
        const scene::Mesh& rest = source.meshes[index].mesh.rest();
        const auto& pose = moment.poses[index];
        state_->objects.push_back(place(rest, pose ? pose->positions : rest.positions,
                                        pose ? pose->normals : rest.normals, moment.matrices[i],
                                        source.description.objects[i].material));
        for (const glm::vec3& position : state_->objects.back().positions)
            largest = std::max({largest, std::abs(double{position.x}), std::abs(double{position.y}),
                                std::abs(double{position.z})});
    }
    state_->surfaceOffset = 4e-6 * largest;
    state_->device.reset(rtcNewDevice(nullptr));
    if (!state_->device) throw RunError("nephrite: error: Embree does not start");
    state_->scene.reset(rtcNewScene(state_->device.get()));
    rtcSetSceneFlags(state_->scene.get(), RTC_SCENE_FLAG_ROBUST);
    for (std::uint32_t i = 0; i < state_->objects.size(); ++i)
        attach(state_->device.get(), state_->scene.get(), state_->objects[i], i);
    rtcCommitScene(state_->scene.get());
}

Geometry::~Geometry() = default;
Geometry::Geometry(Geometry&&) noexcept = default;

std::uint32_t Geometry::objectCount() const {
    return static_cast<std::uint32_t>(state_->objects.size());
}
std::uint32_t Geometry::materialOf(std::uint32_t object) const {
    return state_->objects[object].material;
}
std::uint32_t Geometry::triangleCount(std::uint32_t object) const {
    return static_cast<std::uint32_t>(state_->objects[object].indices.size() / 3);
}
Triangle Geometry::triangle(std::uint32_t object, std::uint32_t index) const {
    return state_->triangle(object, index);
}
double Geometry::surfaceOffset() const {
    return state_->surfaceOffset;
}
const scene::EnclosingSphere& Geometry::bounds() const {
    return state_->bounds;
}

std::optional<SurfacePoint> Geometry::trace(const Ray& ray, double from, double to) const {
    const Interval interval = within(state_->bounds, ray, {from, to});
    if (!(interval.from < interval.to)) return std::nullopt;
    RTCRayHit query =
        embreeRay(ray.origin + interval.from * ray.direction, ray.direction, interval.to - interval.from);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(state_->scene.get(), &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return state_->refine(ray, interval.from + double{query.ray.tfar}, query.hit.geomID, query.hit.primID);
}

NearestSurface Geometry::nearest(const glm::dvec3& point, std::uint32_t object, double limit) const {
    struct Search {
        const State& state;
        glm::dvec3 point;
        std::uint32_t object;
        std::uint32_t triangle;
        glm::dvec3 weights;
        double distance;
    };
    Search search{*state_, point, object, 0, {1, 0, 0}, limit};
    RTCPointQuery query{};
    query.x = static_cast<float>(point.x);
    query.y = static_cast<float>(point.y);
    query.z = static_cast<float>(point.z);
    query.radius = static_cast<float>(limit + state_->surfaceOffset);
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    const auto visit = [](RTCPointQueryFunctionArguments* arguments) {
        Search& found = *static_cast<Search*>(arguments->userPtr);
        if (arguments->geomID != found.object) return false;
        const Triangle triangle = found.state.triangle(found.object, arguments->primID);
        const glm::dvec3 weights = closestWeights(triangle, found.point);
        const glm::dvec3 closest = weights.x * triangle.positions[0] + weights.y * triangle.positions[1] +
                                   weights.z * triangle.positions[2];
        const double distance = glm::distance(closest, found.point);
        if (!(distance < found.distance)) return false;
        found.triangle = arguments->primID;
        found.weights = weights;
        found.distance = distance;
        arguments->query->radius = static_cast<float>(distance + found.state.surfaceOffset);
        return true;
    };
    rtcPointQuery(state_->scene.get(), &query, &context, visit, &search);
    NearestSurface nearest;
    if (!(search.distance < limit)) return nearest;
    const PlacedMesh& mesh = state_->objects[object];
    nearest.distance = search.distance;
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
        const std::uint32_t vertex = mesh.indices[3 * std::size_t{search.triangle} + corner];
        nearest.textureCoordinates +=
            search.weights[static_cast<int>(corner)] * glm::dvec2(mesh.textureCoordinates[vertex]);
    }
    return nearest;
}

glm::dvec3 Geometry::normalChange(const SurfacePoint& point, const glm::dvec3& step) const {
    const Triangle corners = state_->triangle(point.object, point.triangle);
    const WeightGradients gradients = weightGradients(corners);
    const double second = glm::dot(gradients.second, step);
    const double third = glm::dot(gradients.third, step);
    const glm::dvec3 change = second * (corners.normals[1] - corners.normals[0]) +
                              third * (corners.normals[2] - corners.normals[0]);
    const double length = glm::length(interpolatedNormal(corners, point.weights));
    return (change - point.normal * glm::dot(point.normal, change)) / length;
}

}  // namespace nephrite::truth
