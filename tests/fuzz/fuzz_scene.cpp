// Any bytes as a scene file: read, or refused with faults that each have a line; what was read has finite
// views and matrices. Meshes and images are not loaded.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "scene/object_motion.h"
#include "scene/scene_description.h"
#include "scene/view.h"

namespace {

using namespace nephrite;
using namespace nephrite::scene;

/// Aborts unless every element is finite.
template<typename Matrix>
void requireFinite(const Matrix& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row])) std::abort();
}

void requireGoodFaults(const std::vector<Diagnostic>& faults) {
    for (const Diagnostic& fault : faults)
        if (fault.message.empty() || toLine(fault).find('\n') != std::string::npos) std::abort();
}

void requireUsable(const SceneDescription& scene) {
    requireFinite(cameraView(scene.camera, 640, 480).viewProjection);
    for (const LightDescription& light : scene.lights) {
        const EnclosingSphere sphere{{0, 0, 0}, 1};
        for (const View& view : lightViews(light.position, 0, sphere, lightViewCount(light.position, sphere)))
            requireFinite(view.viewProjection);
    }
    const Box box{glm::vec3(-1), glm::vec3(1)};
    for (const ObjectDescription& object : scene.objects) {
        if (object.material >= scene.materials.size()) std::abort();
        requireFinite(worldMatrix(object, box, scene.millimetersPerUnit, 0.3));
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        Diagnostics diagnostics;
        const json::Value value =
            json::parse(std::string(reinterpret_cast<const char*>(data), size), "fuzzed");
        const SceneDescription scene = readScene(value, {}, diagnostics);
        requireGoodFaults(diagnostics.errors());
        requireGoodFaults(diagnostics.warnings());
        if (!diagnostics.hasErrors()) requireUsable(scene);
    } catch (const InputError& error) {
        if (error.faults().empty()) std::abort();
        requireGoodFaults(error.faults());
    }
    return 0;
}
