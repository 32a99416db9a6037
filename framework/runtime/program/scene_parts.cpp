// Bindings and members of set 0 as parts of a scene.
#include "runtime/program/scene_parts.h"

#include <array>
#include <cstddef>

#include "gpu/reflection.h"
#include "scene/shader_interface.h"

namespace nephrite::runtime {
namespace {

using graph::ScenePart;
using scene::SceneBinding;

struct BindingPart {
    SceneBinding binding;
    ScenePart part;
};
constexpr std::array<BindingPart, 7> bindingParts{{{SceneBinding::Lights, ScenePart::Lights},
                                                   {SceneBinding::LightViews, ScenePart::Lights},
                                                   {SceneBinding::Materials, ScenePart::Materials},
                                                   {SceneBinding::Layers, ScenePart::Materials},
                                                   {SceneBinding::LayerTexels, ScenePart::Materials},
                                                   {SceneBinding::EnvironmentMap, ScenePart::Environment},
                                                   {SceneBinding::Objects, ScenePart::Geometry}}};

/// Members of the frame's block in order: each reaches to where the next begins.
struct MemberPart {
    std::size_t offset;
    ScenePart part;
};
constexpr std::array<MemberPart, 6> frameParts{
    {{offsetof(scene::GpuFrame, camera), ScenePart::Camera},
     {offsetof(scene::GpuFrame, lightCount), ScenePart::Lights},
     {offsetof(scene::GpuFrame, lightViewCount), ScenePart::Lights},
     {offsetof(scene::GpuFrame, materialCount), ScenePart::Materials},
     {offsetof(scene::GpuFrame, time), ScenePart::Time},
     {offsetof(scene::GpuFrame, environmentCoefficients), ScenePart::Environment}}};

graph::SceneParts partsOfRange(const gpu::ByteRange& range) {
    graph::SceneParts parts = 0;
    for (std::size_t i = 0; i < frameParts.size(); ++i) {
        const std::size_t end =
            i + 1 < frameParts.size() ? frameParts[i + 1].offset : sizeof(scene::GpuFrame);
        if (range.offset < end && range.offset + range.bytes > frameParts[i].offset)
            parts |= bit(frameParts[i].part);
    }
    return parts;
}

constexpr graph::SceneParts everyFramePart = bit(ScenePart::Camera) | bit(ScenePart::Lights) |
                                             bit(ScenePart::Materials) | bit(ScenePart::Time) |
                                             bit(ScenePart::Environment);

graph::SceneParts partsOfFrame(std::span<const std::uint32_t> spirv) {
    const auto members = gpu::usedMembers(spirv, 0, static_cast<std::uint32_t>(SceneBinding::Frame));
    graph::SceneParts parts = 0;
    for (const gpu::ByteRange& member : members) parts |= partsOfRange(member);
    // A block read as a whole shows no members.
    return parts == 0 ? everyFramePart : parts;
}

}  // namespace

graph::SceneParts scenePartsOf(std::span<const std::uint32_t> spirv) {
    const gpu::ShaderReflection reflection = gpu::reflect(spirv);
    graph::SceneParts parts = 0;
    for (const BindingPart& entry : bindingParts)
        if (reflection.uses(0, static_cast<std::uint32_t>(entry.binding))) parts |= bit(entry.part);
    if (reflection.uses(0, static_cast<std::uint32_t>(SceneBinding::Frame))) parts |= partsOfFrame(spirv);
    return parts;
}

std::uint64_t versionOf(const scene::SceneVersions& versions, graph::SceneParts parts) {
    // Each counter only grows, so their sum stays the same only if all of them do.
    std::uint64_t sum = 0;
    const auto add = [&](ScenePart part, std::uint64_t version) {
        if ((parts & bit(part)) != 0) sum += version;
    };
    add(ScenePart::Camera, versions.camera);
    add(ScenePart::Lights, versions.lights);
    add(ScenePart::Geometry, versions.geometry);
    add(ScenePart::Materials, versions.materials);
    add(ScenePart::Environment, versions.environment);
    add(ScenePart::Time, versions.time);
    return sum;
}

}  // namespace nephrite::runtime
