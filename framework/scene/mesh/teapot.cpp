// The teapot: each patch becomes 10 x 10 quads. At the top of the lid and the bottom's centre the patches end
// in a point; there the first row is triangles, every second of whose spokes is split by a point of the
// surface, so that every patch has 200 triangles and none is degenerate.
#include <cmath>

#include "scene/mesh/prepare.h"
#include "scene/mesh/procedural.h"
#include "scene/mesh/teapot_data.h"

namespace nephrite::scene {
namespace {

constexpr int steps = 10;
/// Parameters are counted in half steps, because the split spokes need them.
constexpr int halfSteps = 2 * steps;

using Row = std::array<glm::dvec3, 4>;
using ControlGrid = std::array<Row, 4>;

/// The cubic at i / halfSteps. Summed symmetrically, so that two patches meet exactly whichever way they run.
glm::dvec3 cubic(const Row& p, int i) {
    const double t = static_cast<double>(i) / halfSteps;
    const double r = static_cast<double>(halfSteps - i) / halfSteps;
    return (r * r * r * p[0] + t * t * t * p[3]) + (3.0 * t * r * r * p[1] + 3.0 * t * t * r * p[2]);
}

glm::dvec3 cubicSlope(const Row& p, int i) {
    const double t = static_cast<double>(i) / halfSteps;
    const double r = static_cast<double>(halfSteps - i) / halfSteps;
    return 3.0 * (r * r * (p[1] - p[0]) + 2.0 * t * r * (p[2] - p[1]) + t * t * (p[3] - p[2]));
}

/// A bicubic Bezier patch S(u, v), u along the four points of a row, v across the rows.
class Patch {
  public:
    explicit Patch(const ControlGrid& control) : control_(control) {}

    glm::dvec3 position(int u, int v) const { return cubic(column(u), v); }

    glm::dvec3 normal(int u, int v) const {
        glm::dvec3 alongU = slopeU(u, v);
        const glm::dvec3 alongV = cubicSlope(column(u), v);
        // Where an edge has shrunk to a point, dS/du is 0 and turns into its own slope.
        if (glm::length(alongU) < 1e-9) alongU = v == 0 ? slopeU(u, 1) : slopeU(u, v - 1);
        return glm::normalize(glm::cross(alongU, alongV));
    }

    bool startsInPoint() const {
        const Row& row = control_[0];
        return row[0] == row[1] && row[1] == row[2] && row[2] == row[3];
    }

  private:
    Row column(int u) const {
        return {cubic(control_[0], u), cubic(control_[1], u), cubic(control_[2], u), cubic(control_[3], u)};
    }
    glm::dvec3 slopeU(int u, int v) const {
        return cubic({cubicSlope(control_[0], u), cubicSlope(control_[1], u), cubicSlope(control_[2], u),
                      cubicSlope(control_[3], u)},
                     v);
    }

    ControlGrid control_;
};

/// The published axes have z up; ours y up.
glm::vec3 upright(const glm::dvec3& p) {
    return {p.x, p.z, -p.y};
}

class Builder {
  public:
    void add(const ControlGrid& control, bool turnedOver) {
        const Patch patch(control);
        patch_ = &patch;
        turnedOver_ = turnedOver;
        const bool pointed = patch.startsInPoint();
        if (pointed) addPointedRow();
        for (int v = pointed ? 2 : 0; v < halfSteps; v += 2) {
            for (int u = 0; u < halfSteps; u += 2) {
                addTriangle({u, v}, {u + 2, v}, {u + 2, v + 2});
                addTriangle({u, v}, {u + 2, v + 2}, {u, v + 2});
            }
        }
    }

    Mesh finish() {
        weld(mesh_);
        return std::move(mesh_);
    }

  private:
    void addPointedRow() {
        for (int u = 0; u < halfSteps; u += 2) {
            const glm::ivec2 left(u, 2);
            const glm::ivec2 right(u + 2, 2);
            // The point itself, with the u of the middle so that the texture spreads evenly around it.
            const glm::ivec2 point(u + 1, 0);
            if (u % 4 == 0) {
                const glm::ivec2 split(u, 1);
                addTriangle(point, right, split);
                addTriangle(split, right, left);
            } else {
                const glm::ivec2 split(u + 2, 1);
                addTriangle(point, split, left);
                addTriangle(split, right, left);
            }
        }
    }

    void addTriangle(const glm::ivec2& a, const glm::ivec2& b, const glm::ivec2& c) {
        addVertex(a);
        addVertex(turnedOver_ ? c : b);
        addVertex(turnedOver_ ? b : c);
    }

    void addVertex(const glm::ivec2& at) {
        const glm::dvec3 normal = patch_->normal(at.x, at.y) * (turnedOver_ ? -1.0 : 1.0);
        mesh_.indices.push_back(static_cast<std::uint32_t>(mesh_.positions.size()));
        mesh_.positions.push_back(upright(patch_->position(at.x, at.y)));
        mesh_.normals.push_back(upright(normal));
        mesh_.textureCoordinates.emplace_back(glm::vec2(at) / static_cast<float>(halfSteps));
    }

    const Patch* patch_ = nullptr;
    bool turnedOver_ = false;
    Mesh mesh_;
};

ControlGrid controlGrid(const teapot_data::Patch& patch, double signX, double signY) {
    ControlGrid grid;
    for (std::size_t i = 0; i < 16; ++i) {
        const auto& point = teapot_data::controlPoints[patch.points[i]];
        grid[i / 4][i % 4] = {signX * point[0], signY * point[1], point[2]};
    }
    return grid;
}

}  // namespace

Mesh teapot() {
    Builder builder;
    for (const teapot_data::Patch& patch : teapot_data::patches) {
        const bool mirrorX = patch.symmetry == teapot_data::Symmetry::xAndY;
        for (const double signX : {1.0, -1.0}) {
            if (signX < 0.0 && !mirrorX) continue;
            // Each mirror turns a patch inside out.
            for (const double signY : {1.0, -1.0})
                builder.add(controlGrid(patch, signX, signY), signX * signY < 0.0);
        }
    }
    return builder.finish();
}

}  // namespace nephrite::scene
