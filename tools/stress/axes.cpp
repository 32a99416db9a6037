// See axes.h.
#include "stress/axes.h"

namespace nephrite::stress {
namespace {

void eachLayer(SceneValues& scene, const Triple& absorption, const Triple& scattering) {
    for (MaterialValues& material : scene.materials) {
        for (LayerValues& layer : material.layers) {
            layer.absorption = absorption;
            layer.scattering = scattering;
        }
    }
}

constexpr LayerValues apple{};

Axis coefficients() {
    return {"coefficients",
            {{"no-absorption",
              [](SceneValues& s) {
                  eachLayer(s, {0, 0, 0}, apple.scattering);
              }},
             {"no-scattering",
              [](SceneValues& s) {
                  eachLayer(s, apple.absorption, {0, 0, 0});
              }},
             {"clear",
              [](SceneValues& s) {
                  eachLayer(s, {0, 0, 0}, {0, 0, 0});
              }},
             {"dense",
              [](SceneValues& s) {
                  eachLayer(s, {1e4, 1, 1e-6}, {1e4, 1e4, 1e4});
              }},
             {"black",
              [](SceneValues& s) {
                  eachLayer(s, {1e4, 1e4, 1e4}, {1e-6, 1, 0});
              }},
             {"thin",
              [](SceneValues& s) {
                  eachLayer(s, {1e-6, 0, 1e-6}, {1e-6, 1e-6, 0});
              }},
             {"uneven", [](SceneValues& s) {
                  eachLayer(s, {1e-6, 1, 1e4}, {1e4, 1e-6, 1});
              }}}};
}

template<int thousandths>
void setEta(SceneValues& scene) {
    for (MaterialValues& material : scene.materials) material.eta = thousandths * 0.001;
}

void setG(SceneValues& scene, double g) {
    for (MaterialValues& material : scene.materials) material.g = g;
}

Axis phase() {
    return {"phase",
            {{"g-forward", [](SceneValues& s) { setG(s, 0.999999); }},
             {"g-backward", [](SceneValues& s) { setG(s, -0.999999); }},
             {"g-one", [](SceneValues& s) { setG(s, 1); }},
             {"g-minus-one", [](SceneValues& s) { setG(s, -1); }},
             {"g-skin", [](SceneValues& s) { setG(s, 0.95); }}}};
}

Axis index() {
    return {"index",
            {{"eta-1", setEta<1000>},
             {"eta-low", setEta<800>},
             {"eta-high", setEta<4000>},
             {"eta-near-1", [](SceneValues& s) {
                  for (MaterialValues& material : s.materials) material.eta = 1.0001;
              }}}};
}

/// As many copies of each material's layer as there are thicknesses.
void stack(SceneValues& scene, const std::vector<double>& thicknesses) {
    for (MaterialValues& material : scene.materials) {
        const LayerValues layer = material.layers.front();
        material.layers.clear();
        for (const double thickness : thicknesses)
            material.layers.push_back({layer.absorption, layer.scattering, thickness});
    }
}

constexpr double infinite = std::numeric_limits<double>::infinity();

Axis layers() {
    return {"layers",
            {{"layer-zero", [](SceneValues& s) { stack(s, {0}); }},
             {"layer-zero-first",
              [](SceneValues& s) {
                  stack(s, {0, infinite});
              }},
             {"layer-thin",
              [](SceneValues& s) {
                  stack(s, {1e-6, infinite});
              }},
             {"layer-thick",
              [](SceneValues& s) {
                  stack(s, {1e6, infinite});
              }},
             {"layers-equal",
              [](SceneValues& s) {
                  stack(s, {1, 1});
              }},
             {"layers-five", [](SceneValues& s) {
                  stack(s, {0.1, 0, 1e-6, 1e6, infinite});
              }}}};
}

Axis lights() {
    return {"light",
            {{"light-grazing",
              [](SceneValues& s) {
                  s.lights = {{{1000, 0, 2.001}, 5e6}};
              }},
             {"light-on-surface",
              [](SceneValues& s) {
                  s.lights = {{{0, 0, 10}, 5000}, {{0, 0, 2}, 5000}};
              }},
             {"light-inside",
              [](SceneValues& s) {
                  s.lights = {{{1, 0, 1}, 5000}};
              }},
             {"light-at-centre",
              [](SceneValues& s) {
                  s.lights = {{{0, 0, 0}, 5000}};
              }},
             {"light-far",
              [](SceneValues& s) {
                  s.lights = {{{0, 6e6, 8e6}, 3e14}};
              }},
             {"light-bright", [](SceneValues& s) { s.lights[0].intensity = 1e12; }},
             {"light-none", [](SceneValues& s) { s.lights.clear(); }},
             {"light-several",
              [](SceneValues& s) {
                  s.lights = {{{30, 30, 10}, 5000}, {{0, 0, -40}, 1e6}, {{-30, 0, 0}, 1}};
              }},
             {"environment", [](SceneValues& s) { s.environment = 1; }}}};
}

Axis views() {
    return {"view",
            {{"view-grazing",
              [](SceneValues& s) {
                  s.camera = {40, 0, 2.001}, s.target = {0, 0, 2};
              }},
             {"view-inside",
              [](SceneValues& s) {
                  s.camera = {0, 0, 1};
              }},
             {"view-on-surface",
              [](SceneValues& s) {
                  s.camera = {0, 0, 10}, s.near = 1e-3, s.target = {0, 5, 0};
              }},
             {"view-from-afar",
              [](SceneValues& s) {
                  s.camera = {0, 0, 4000}, s.near = 100, s.far = 1e5;
              }},
             {"view-elsewhere", [](SceneValues& s) {
                  s.target = {0, 0, 80};
              }}}};
}

template<Shape shape>
void setShape(SceneValues& scene) {
    scene.objects.front().shape = shape;
}

Axis objects() {
    return {"objects",
            {{"slab", setShape<Shape::slab>},
             {"missing-normals", setShape<Shape::missingNormals>},
             {"inward-normals", setShape<Shape::inwardNormals>},
             {"flipped-winding", setShape<Shape::flippedWinding>},
             {"open", setShape<Shape::open>},
             {"slivers", setShape<Shape::slivers>},
             {"zero-area", setShape<Shape::zeroArea>},
             {"coincident", setShape<Shape::coincident>},
             {"empty", [](SceneValues& s) { s.objects.clear(); }},
             {"two-materials", [](SceneValues& s) {
                  s.materials.push_back({{{{1, 0, 0.1}, {0.1, 5, 1}, 2}}, 0.5, 1.5, true});
                  s.objects.push_back({Shape::slab, {5, 2, 3}, 1});
              }}}};
}

Axis scales() {
    return {"scale",
            {{"scale-small", [](SceneValues& s) { s.scale = 1e-4; }},
             {"scale-large", [](SceneValues& s) { s.scale = 1e4; }}}};
}

}  // namespace

const std::vector<Axis>& axes() {
    static const std::vector<Axis> all{coefficients(), phase(), index(),   layers(),
                                       lights(),       views(), objects(), scales()};
    return all;
}

std::vector<NamedScene> singleScenes() {
    std::vector<NamedScene> scenes;
    for (const Axis& axis : axes()) {
        for (const Nasty& nasty : axis.values) {
            NamedScene& sphere = scenes.emplace_back(NamedScene{"sphere+" + nasty.name, {}});
            nasty.apply(sphere.scene);
            if (axis.name == "objects") continue;
            NamedScene& slab = scenes.emplace_back(NamedScene{"slab+" + nasty.name, {}});
            slab.scene.objects.front().shape = Shape::slab;
            nasty.apply(slab.scene);
        }
    }
    return scenes;
}

}  // namespace nephrite::stress
