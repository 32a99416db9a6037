// The facts about a scene that expressions may name.
#include <array>

#include "graph/compile.h"

namespace nephrite::graph {
namespace {

struct Fact {
    std::string_view name;
    std::uint32_t SceneFacts::*member;
};
constexpr std::array<Fact, 9> facts{{{"translucentMaterials", &SceneFacts::translucentMaterials},
                                     {"opaqueMaterials", &SceneFacts::opaqueMaterials},
                                     {"pointLights", &SceneFacts::pointLights},
                                     {"environment", &SceneFacts::environment},
                                     {"maxLayers", &SceneFacts::maxLayers},
                                     {"layerTextures", &SceneFacts::layerTextures},
                                     {"animated", &SceneFacts::animated},
                                     {"objects", &SceneFacts::objects},
                                     {"lightViews", &SceneFacts::lightViews}}};

}  // namespace

std::optional<double> SceneFacts::find(std::string_view name) const {
    for (const Fact& fact : facts) {
        if (fact.name == name) return static_cast<double>(this->*fact.member);
    }
    return std::nullopt;
}

std::vector<std::string_view> SceneFacts::names() {
    std::vector<std::string_view> result;
    for (const Fact& fact : facts) result.push_back(fact.name);
    return result;
}

}  // namespace nephrite::graph
