// Walks the flux pyramid from the top: a patch is taken as a whole where it is small beside its distance, otherwise its
// parts are (Barnes and Hut 1986, here without a stack: the next place follows from the one at hand).
// Reads the ports patchAtlas and spreadAtlas.
#ifndef FLUX_TRAVERSAL_GLSL
#define FLUX_TRAVERSAL_GLSL

#include "flux_levels.glsl"
#include "flux_patch.glsl"
#include "surface.glsl"

struct PyramidPlace {
    int level;
    ivec2 texel;
};

/// Width and height of level 0.
int baseSize() {
    return extent(patchAtlas).y;
}

PyramidPlace pyramidTop() {
    return PyramidPlace(topLevel(baseSize()), ivec2(0));
}

/// The patch at a place; `layer` is that of a light view and a material.
FluxPatch patchAt(PyramidPlace place, int layer) {
    ivec2 q = levelOrigin(place.level, baseSize()) + place.texel;
    return patchOf(loadLayer(patchAtlas, q, layer), loadLayer(spreadAtlas, q, layer));
}

/// Whether a patch is too wide to be taken as a whole: its standard deviation exceeds `opening`^(1/2) times the distance of
/// its light's sources, which lie `nearest` mm or more below it.
bool isOpened(FluxPatch lit, PyramidPlace place, float squaredDistance, float nearest, float opening) {
    return lit.flux > 0.0 && place.level > 0 && lit.variance > opening * (squaredDistance + nearest * nearest);
}

/// The first part of the patch at hand, one level finer.
PyramidPlace firstPart(PyramidPlace place) {
    return PyramidPlace(place.level - 1, 2 * place.texel);
}

/// The place after the patch at hand and all its parts. After the last one its level is above the top.
PyramidPlace nextPlace(PyramidPlace place) {
    int base = baseSize();
    int top = topLevel(base);
    while (place.level < top) {
        int lastParent = levelSize(place.level + 1, base) - 1;
        ivec2 parent = min(place.texel >> 1, ivec2(lastParent));
        // The last parent has a third row and column of parts where the finer level's size is odd.
        ivec2 last = mix(2 * parent + 1, ivec2(levelSize(place.level, base) - 1), equal(parent, ivec2(lastParent)));
        if (place.texel.x < last.x) return PyramidPlace(place.level, place.texel + ivec2(1, 0));
        if (place.texel.y < last.y) return PyramidPlace(place.level, ivec2(2 * parent.x, place.texel.y + 1));
        place = PyramidPlace(place.level + 1, parent);
    }
    return PyramidPlace(top + 1, ivec2(0));
}

/// Which layer of the pyramid holds a material's patches as a light's view sees them.
int patchLayer(uint view, uint material) {
    return int(view * materialCount + material);
}

/// Half the second-order term of the mean of a kernel (1 + s) e^-s / d^3, s = sigma_tr d, over a patch, relative to the
/// kernel at the patch's mean squared distance. Squared distances u vary over a flat patch by Var u = 2 v r^2, v the patch's
/// variance and r the part of its distance that lies in its plane; the second derivative by u is (15 + 15 s + 6 s^2 + s^3) e^-s / (4 d^7).
vec3 kernelCurvature(vec3 squaredLateral, float variance, vec3 squaredDistance, vec3 s) {
    vec3 derivative = (15.0 + s * (15.0 + s * (6.0 + s))) / (1.0 + s);
    return 0.25 * variance * squaredLateral / (squaredDistance * squaredDistance) * derivative;
}

/// (1 + s) e^-(s - lead) / d^3, 1/mm^3.
vec3 kernelAt(vec3 squaredDistance, vec3 transport, vec3 lead) {
    vec3 inverseDistance = inversesqrt(squaredDistance);
    vec3 s = transport * squaredDistance * inverseDistance;
    return (1.0 + s) * exp(lead - s) * inverseDistance * inverseDistance * inverseDistance;
}

/// Mean of that kernel over a patch; `squaredDistance` includes the variance. The series 1 + k + k^2 stands for the higher
/// moments of a patch, k limited to 1 because it does not converge beyond.
vec3 meanKernel(vec3 squaredLateral, float variance, vec3 squaredDistance, vec3 transport, vec3 lead) {
    vec3 s = transport * sqrt(squaredDistance);
    vec3 k = min(kernelCurvature(squaredLateral, variance, squaredDistance, s), vec3(1.0));
    return (1.0 + k * (1.0 + k)) * kernelAt(squaredDistance, transport, lead);
}

/// By how much, relative to its value, the kernel falls over a patch while something proportional to r^2 rises by its own
/// mean: -Var u / r^2 times the kernel's derivative by u, (3 + 3 s + s^2) e^-s / (2 d^5); at most 1.
vec3 kernelFall(float variance, vec3 squaredDistance, vec3 transport) {
    vec3 s = transport * sqrt(squaredDistance);
    return min(variance * (3.0 + s * (3.0 + s)) / ((1.0 + s) * squaredDistance), vec3(1.0));
}

/// Depth of a source whose light enters through a disc of `squaredRadius` mm^2 instead of a point: the peak of its
/// profile is then the disc's mean, the total stays. sqrt(D (D + z)/2), D = sqrt(z^2 + a^2); z where a = 0.
vec3 blurredDepth(vec3 z, float squaredRadius) {
    vec3 rim = sqrt(z * z + squaredRadius);
    return sqrt(0.5 * rim * (rim + z));
}

/// Squared radius, mm^2, of the disc as large as a light texel of level 0 at a surface point.
float squaredTexelRadius(uint view, vec3 point, vec3 normal) {
    const float inversePi = 0.318309886183791;
    vec3 fromLight = point - lightViews[view].position;
    float depth = abs(dot(fromLight, lightViews[view].forward));
    vec2 width = 2.0 * depth * vec2(lightViews[view].tanHalfFovX, lightViews[view].tanHalfFovY) / float(baseSize());
    float cosine = abs(dot(unitOrZero(fromLight), normal));
    return width.x * width.y * inversePi / max(cosine, 0.1);
}

#endif
