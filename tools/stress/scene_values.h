// A stressed scene as plain values, and the files that say it.
#pragma once

#include <array>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace nephrite::stress {

using Triple = std::array<double, 3>;

struct LayerValues {
    Triple absorption{0.003, 0.0034, 0.046};  ///< 1/mm
    Triple scattering{2.29, 2.39, 1.97};      ///< 1/mm
    double thickness = std::numeric_limits<double>::infinity();
};

struct MaterialValues {
    std::vector<LayerValues> layers{LayerValues{}};
    double g = 0;
    double eta = 1.3;
    bool specular = false;
};

/// The shapes objects may have, all within a sphere of radius 10 mm about the object's place.
enum class Shape {
    sphere,
    slab,
    missingNormals,  ///< a coarse sphere from a file without normals
    inwardNormals,   ///< with normals that point inward
    flippedWinding,  ///< with triangles that turn the other way
    open,            ///< the front half of a sphere: no back side to find
    slivers,         ///< triangles a millionth as wide as long, among others
    zeroArea,        ///< triangles without area among others
    coincident,      ///< every triangle twice
    notANumber,      ///< a vertex that is not a number: to be refused
};

struct ObjectValues {
    Shape shape = Shape::sphere;
    Triple place{0, 0, 0};
    std::size_t material = 0;
};

struct LightValues {
    Triple position{30, 30, 10};
    double intensity = 5000;  ///< W/sr, of each channel
};

struct SceneValues {
    Triple camera{0, 0, 40};
    Triple target{0, 0, 0};
    Triple up{0, 1, 0};
    double fovY = 36;  ///< degrees
    double near = 0.5;
    double far = 1000;
    double environment = 0;  ///< W/mm^2/sr, from everywhere
    std::vector<LightValues> lights{LightValues{}};
    std::vector<MaterialValues> materials{MaterialValues{}};
    std::vector<ObjectValues> objects{ObjectValues{}};
    /// Of all lengths; coefficients shrink and intensities grow with its square, so that the picture stays.
    double scale = 1;
};

constexpr double objectRadius = 10;  ///< mm, before `scale`

/// Writes the scene as `folder`/scene.json, and its meshes beside it. Returns the scene's path. Throws
/// RunError if a file cannot be written.
std::filesystem::path write(const SceneValues& scene, const std::filesystem::path& folder);

}  // namespace nephrite::stress
