// The keys of a layers file and what they may hold.
#include "layers_file.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "profile_rules.h"
#include "text/json.h"

namespace nephrite::tools {
namespace {

constexpr std::array<json::Key, 3> fileKeys{
    {{"layers", R"json({"type": "array"})json", "from the surface inward", true},
     {"g", R"json({"type": "number"})json", "mean cosine of the scattering angle"},
     {"eta", R"json({"type": "number"})json", "refractive index inside over outside"}}};
constexpr std::array<json::Key, 3> layerKeys{
    {{"thickness", R"json({"type": ["number", "null"]})json", "mm; absent or null: infinite"},
     {"absorption", R"json({"type": "number"})json", "1/mm", true},
     {"scattering", R"json({"type": "number"})json", "1/mm, not reduced", true}}};

scattering::Layer readLayer(const json::Value& value, Diagnostics& diagnostics) {
    json::ObjectReader object(value, "a layer", layerKeys, diagnostics);
    scattering::Layer layer;
    if (const auto thickness = object.optional("thickness"); thickness && !thickness->isNull())
        scene::readNumber(*thickness, scene::notNegative, layer.thickness, diagnostics);
    scene::readNumber(object, "absorption", scene::notNegative, layer.absorption);
    scene::readNumber(object, "scattering", scene::notNegative, layer.scattering);
    object.finish();
    return layer;
}

void readLayers(const json::Value& value, scattering::LayerStack& stack, Diagnostics& diagnostics) {
    if (!value.isArray() || value.size() == 0)
        return diagnostics.error(value.where(),
                                 fmt::format("expected an array of layers, found {}",
                                             value.isArray() ? "an empty one" : value.describe()));
    for (std::size_t i = 0; i < value.size(); ++i) {
        stack.layers.push_back(readLayer(value.at(i), diagnostics));
        if (i + 1 < value.size() && std::isinf(stack.layers.back().thickness))
            diagnostics.error(value.at(i).where(), "only the last layer may be infinitely thick");
    }
}

}  // namespace

scattering::LayerStack readLayersFile(const std::filesystem::path& file) {
    const json::Value root = json::parseFile(file);
    Diagnostics diagnostics;
    scattering::LayerStack stack;
    json::ObjectReader object(root, "a stack of layers", fileKeys, diagnostics);
    if (const auto layers = object.optional("layers")) readLayers(*layers, stack, diagnostics);
    scene::readNumber(object, "g", anisotropyRule, stack.g);
    scene::readNumber(object, "eta", indexRule, stack.eta);
    object.finish();
    diagnostics.throwIfErrors();
    return stack;
}

}  // namespace nephrite::tools
