// Walks the flux tree from the root: a patch is taken as a whole where it is small beside its distance, otherwise its
// parts are (Barnes and Hut 1986, here without a stack: the next node follows from the one at hand).
// Reads the ports patchPlaces and patchEntries.
#ifndef FLUX_TRAVERSAL_GLSL
#define FLUX_TRAVERSAL_GLSL

#include "flux_patch.glsl"
#include "flux_tree_layout.glsl"
#include "surface.glsl"

/// Which part of a tree is still to be walked.
struct TreeWalk {
    int layer;   // of a light view and material
    int base;
    int root;    // level
    int level;
    int morton;  // within the level
};

/// All of the tree of what a light view sees of a material.
TreeWalk walkOf(uint view, uint material) {
    int base = treeBase(extent(patchPlaces));
    int root = rootLevel(base);
    return TreeWalk(int(view * materialCount + material), base, root, root, 0);
}

/// The next lit patch to be taken as a whole for light that reaches `point`. Patches whose standard deviation exceeds
/// `opening`^(1/2) times the distance of their light's sources, which lie `nearest` mm or more below the surface, are opened.
/// False after the last. The search is a loop of its own, so that neighbours who look at other patches evaluate theirs
/// together.
bool findPatch(inout TreeWalk walk, out FluxPatch lit, vec3 point, float nearest, float opening) {
    ivec2 texel = ivec2(0);
    vec4 place = vec4(0.0);
    bool found = false;
    while (!found && walk.level <= walk.root) {
        texel = nodeTexel(walk.level, walk.morton, walk.base);
        place = loadLayer(patchPlaces, texel, walk.layer);
        vec3 along = point - place.xyz;
        bool opened = walk.level > 0 && place.w > opening * (dot(along, along) + nearest * nearest);
        found = !opened && place.w >= 0.0;
        // The node behind: the first part of an opened one, else the next one, which is that many levels higher as the
        // finished parents are.
        int next = opened ? 4 * walk.morton : walk.morton + 1;
        int up = opened ? -1 : findLSB(next) >> 1;
        up = min(up, walk.root - walk.level + 1);
        walk.morton = up > 0 ? next >> (2 * up) : next;
        walk.level += up;
    }
    lit = found ? patchOf(place, loadLayer(patchEntries, texel, walk.layer)) : darkPatch;
    return found;
}

/// Mean over a patch of a source's kernel (1 + s) e^-s / d^3, s = sigma_tr d, 1/mm^3.
struct PatchKernel {
    vec3 mean;    // of the kernel alone
    vec3 fallen;  // of the kernel times something that rises from the shaded point as r^2, over that one's own mean
    vec3 potential;  // of e^-s / d, 1/mm
};

/// `squaredDistance` u = d^2 includes the variance v; `squaredLateral` r^2 is the part of it that lies in the patch's plane.
/// u varies over a flat patch by Var u = 2 v r^2. For the mean, half the second-order term relative to the value is
/// k = v r^2 (15 + 15 s + 6 s^2 + s^3) / (4 d^4 (1 + s)); the series 1 + k + k^2 stands for the higher moments, k limited to 1
/// because it does not converge beyond. What rises as r^2 meets the kernel where it has fallen: to first order by
/// x = v (3 + 3 s + s^2) / (d^2 (1 + s)), taken as x/(1 + 1.5 x), which stays below 1. `lead` is added to the exponent.
PatchKernel patchKernel(vec3 squaredLateral, float variance, vec3 squaredDistance, vec3 transport, vec3 lead) {
    vec3 inverseDistance = inversesqrt(squaredDistance);
    vec3 inverseSquare = inverseDistance * inverseDistance;
    vec3 s = transport * (squaredDistance * inverseDistance);
    vec3 onePlus = 1.0 + s;
    vec3 value = onePlus * exp(lead - s) * (inverseSquare * inverseDistance);
    vec3 second = 15.0 + s * (15.0 + s * (6.0 + s));
    vec3 k = min(0.25 * variance * squaredLateral * inverseSquare * inverseSquare * second / onePlus, vec3(1.0));
    vec3 mean = (1.0 + k * (1.0 + k)) * value;
    vec3 first = variance * (3.0 + s * (3.0 + s));
    vec3 fall = first / (1.5 * first + onePlus * squaredDistance);
    return PatchKernel(mean, mean - fall * value, mean * squaredDistance / onePlus);
}

/// Depth of a source whose light enters through a disc of `squaredRadius` mm^2 instead of a point: the peak of its
/// profile is then the disc's mean, the total stays. sqrt(D (D + z)/2), D = sqrt(z^2 + a^2); z where a = 0.
vec3 blurredDepth(vec3 z, float squaredRadius) {
    vec3 rim = sqrt(z * z + squaredRadius);
    return sqrt(0.5 * rim * (rim + z));
}

/// Squared radius, mm^2, of the disc as large as a leaf of the tree at a surface point.
float squaredLeafRadius(uint view, vec3 point, vec3 normal) {
    const float inversePi = 0.318309886183791;
    vec3 fromLight = point - lightViews[view].position;
    float depth = abs(dot(fromLight, lightViews[view].forward));
    vec2 width = 2.0 * depth * vec2(lightViews[view].tanHalfFovX, lightViews[view].tanHalfFovY) / float(treeBase(extent(patchPlaces)));
    float cosine = abs(dot(unitOrZero(fromLight), normal));
    return width.x * width.y * inversePi / max(cosine, 0.1);
}

#endif
