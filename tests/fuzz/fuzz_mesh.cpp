// Fuzzes the mesh readers and what follows them. The first byte selects: P = PLY, O = OBJ, else glTF (with
// its check, Assimp's import and one animated pose). Only InputError may come out.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "scene/mesh/animated_mesh.h"
#include "scene/mesh/gltf.h"
#include "scene/mesh/obj.h"
#include "scene/mesh/ply.h"
#include "scene/mesh/prepare.h"
#include "text/diagnostics.h"

namespace {

using namespace nephrite;
using namespace nephrite::scene;

constexpr const char* file = "fuzz";

AnimatedMesh readGltf(std::string_view bytes, Diagnostics& diagnostics) {
    const BufferLoader noFiles = [](const std::string&, const SourceLocation& where) -> std::string {
        throw InputError(where, "no such file");
    };
    RiggedMesh rigged = importGltf(checkGltf(bytes, file, noFiles), file);
    const auto source = prepare(rigged.mesh, std::nullopt, file, diagnostics, movementKinds(rigged.rig));
    return AnimatedMesh(std::move(rigged.mesh), reordered(rigged.rig, source));
}

void readStill(Mesh mesh, std::uint8_t selector, Diagnostics& diagnostics) {
    constexpr TextureMapping mappings[] = {TextureMapping::file, TextureMapping::box,
                                           TextureMapping::spherical};
    prepare(mesh, mappings[selector % 3], file, diagnostics);
}

void read(std::uint8_t selector, std::string_view bytes) {
    Diagnostics diagnostics;
    if (selector == 'P') {
        readStill(readPly(bytes, file, diagnostics),
                  bytes.empty() ? 0 : static_cast<std::uint8_t>(bytes.back()), diagnostics);
    } else if (selector == 'O') {
        readStill(readObj(bytes, file), bytes.empty() ? 0 : static_cast<std::uint8_t>(bytes.back()),
                  diagnostics);
    } else {
        AnimatedMesh mesh = readGltf(bytes, diagnostics);
        const std::vector<std::string> clips = mesh.clipNames();
        if (!clips.empty()) mesh.play(clips.front());
        mesh.at(0.3);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    try {
        read(data[0], std::string_view(reinterpret_cast<const char*>(data) + 1, size - 1));
    } catch (const InputError&) {
        // The readers' answer to bad input.
    }
    return 0;
}
