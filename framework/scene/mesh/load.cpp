// Loading a mesh file by its extension.
#include "scene/mesh/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>

#include "scene/mesh/gltf.h"
#include "scene/mesh/obj.h"
#include "scene/mesh/ply.h"

namespace nephrite::scene {
namespace {

namespace fs = std::filesystem;

/// Larger files are refused rather than read into memory.
constexpr std::uintmax_t largestFile = std::uintmax_t{1} << 31;

/// The file's bytes. Faults name the file, at `where` if another file refers to it.
std::string readBytes(const fs::path& path, const SourceLocation& where) {
    const std::string prefix = where.line > 0 ? fmt::format("\"{}\": ", path.string()) : "";
    std::error_code fault;
    const fs::file_status status = fs::status(path, fault);
    if (!fs::exists(status)) throw InputError(where, prefix + "no such file");
    if (!fs::is_regular_file(status)) throw InputError(where, prefix + "not a file");
    const std::uintmax_t size = fs::file_size(path, fault);
    if (fault) throw InputError(where, prefix + fault.message());
    if (size > largestFile) throw InputError(where, prefix + fmt::format("more than {} bytes", largestFile));
    std::ifstream stream(path, std::ios::binary);
    std::string bytes(static_cast<std::size_t>(size), '\0');
    if (!stream.read(bytes.data(), static_cast<std::streamsize>(size)))
        throw InputError(where, prefix + "cannot be read");
    return bytes;
}

std::string lowerExtension(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

AnimatedMesh finishMesh(Mesh mesh, std::optional<TextureMapping> mapping, const std::string& file,
                        Diagnostics& diagnostics) {
    prepare(mesh, mapping, file, diagnostics);
    return AnimatedMesh(std::move(mesh));
}

AnimatedMesh loadGltf(const fs::path& path, std::string bytes, std::optional<TextureMapping> mapping,
                      Diagnostics& diagnostics) {
    const std::string file = path.string();
    const BufferLoader loader = [&](const std::string& name, const SourceLocation& where) {
        return readBytes(path.parent_path() / name, where);
    };
    RiggedMesh rigged = importGltf(checkGltf(bytes, file, loader), file);
    const std::vector<std::uint32_t> source =
        prepare(rigged.mesh, mapping, file, diagnostics, movementKinds(rigged.rig));
    return AnimatedMesh(std::move(rigged.mesh), reordered(rigged.rig, source));
}

}  // namespace

AnimatedMesh loadMesh(const fs::path& path, std::optional<TextureMapping> mapping, Diagnostics& diagnostics) {
    const std::string file = path.string();
    const std::string extension = lowerExtension(path);
    constexpr std::string_view known[] = {".ply", ".obj", ".gltf", ".glb"};
    if (std::find(std::begin(known), std::end(known), extension) == std::end(known)) {
        throw InputError(
            {file, 0, 0},
            fmt::format("unknown mesh format \"{}\", expected .ply, .obj, .gltf or .glb", extension));
    }
    std::string bytes = readBytes(path, {file, 0, 0});
    if (extension == ".ply") return finishMesh(readPly(bytes, file, diagnostics), mapping, file, diagnostics);
    if (extension == ".obj") return finishMesh(readObj(bytes, file), mapping, file, diagnostics);
    return loadGltf(path, std::move(bytes), mapping, diagnostics);
}

}  // namespace nephrite::scene
