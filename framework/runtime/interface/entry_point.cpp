// main() of a node's shader, around the function that its author writes.
#include <fmt/format.h>

#include "runtime/interface/draft.h"
#include "runtime/interface/glsl_template.h"

namespace nephrite::runtime {
namespace {

constexpr std::string_view pixelEntry = R"(
void main() {
    uvec2 p = gl_GlobalInvocationID.xy;
    if (p.x < dispatch.width && p.y < dispatch.height) pixel(ivec2(p));
}
)";

// One group a tile; the list names them by their first texel.
constexpr std::string_view tileEntry = R"(void main() {
    uint word = tileList[@FIRST@u + dispatch.layer * @TILES@u + gl_WorkGroupID.x];
    uvec2 p = uvec2(word & 0xffffu, word >> 16) + gl_LocalInvocationID.xy;
    if (p.x < dispatch.width && p.y < dispatch.height) @CALL@;
}
)";

constexpr std::string_view gridEntry = R"(
void main() { compute(gl_GlobalInvocationID); }
)";

// A long buffer takes several rows of workgroups.
constexpr std::string_view linearEntry = R"(
void main() {
    uint row = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    compute(uvec3(gl_GlobalInvocationID.y * row + gl_GlobalInvocationID.x, 0u, 0u));
}
)";

constexpr std::string_view fragment =
    "struct Fragment { vec3 position; vec3 normal; vec2 uv; uint material; ivec2 pixel; bool front; };";

constexpr std::string_view fragmentEntry = R"(
layout(location = 0) in vec3 fragmentPosition;
layout(location = 1) in vec3 fragmentNormal;
layout(location = 2) in vec2 fragmentUv;
layout(location = 3) in flat uint fragmentMaterial;
void main() {
    float squaredLength = dot(fragmentNormal, fragmentNormal);
    vec3 unit = squaredLength > 0.0 ? fragmentNormal * inversesqrt(squaredLength) : vec3(0.0, 0.0, 1.0);
    vec3 towardsViewer = gl_FrontFacing ? unit : -unit;
    fragment(Fragment(fragmentPosition, towardsViewer, fragmentUv, fragmentMaterial, ivec2(gl_FragCoord.xy), gl_FrontFacing));
}
)";

constexpr std::string_view squareGroups = "layout(local_size_x = 8, local_size_y = 8) in;";
constexpr std::string_view linearGroups = "layout(local_size_x = 64) in;";

void addTileEntry(InterfaceDraft& draft) {
    const graph::Index list = draft.pass().tileList;
    draft.addBuffer("tileList", "uint", list, "readonly ");
    draft.addLine(squareGroups);
    const std::uint32_t layers = tileListLayers(draft.plan(), draft.pass());
    const std::uint32_t length = draft.plan().resources[list].extent.width;
    const bool isPixel = draft.type().kind == graph::PassKind::Pixel;
    draft.setEntryPoint(fillIn(tileEntry, {{"FIRST", std::to_string(4 * layers)},
                                           {"TILES", std::to_string(length / layers - 4)},
                                           {"CALL", isPixel ? "pixel(ivec2(p))" : "compute(uvec3(p, 0u))"}}));
}

bool firstOutputIsBuffer(const InterfaceDraft& draft) {
    return draft.pass().outputs.count > 0 && draft.plan().resources[draft.output(0)].isBuffer;
}

}  // namespace

void addEntryPoint(InterfaceDraft& draft) {
    if (draft.isRaster()) {
        draft.addLine(fragment);
        return draft.setEntryPoint(std::string(fragmentEntry));
    }
    if (draft.isOverTiles()) return addTileEntry(draft);
    const bool isLinear = firstOutputIsBuffer(draft);
    draft.addLine(isLinear ? linearGroups : squareGroups);
    const bool isPixel = draft.type().kind == graph::PassKind::Pixel;
    draft.setEntryPoint(std::string(isPixel ? pixelEntry : isLinear ? linearEntry : gridEntry));
}

}  // namespace nephrite::runtime
