// Reading Wavefront OBJ.
#include "scene/mesh/obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "scene/mesh/text_cursor.h"

namespace nephrite::scene {
namespace {

constexpr std::uint32_t none = 0xffffffffu;

/// Statements of the format that say nothing about triangles.
constexpr std::string_view passedOver[] = {
    "o",        "g",    "s",          "mg",        "usemtl", "mtllib", "usemap", "maplib", "vp",
    "p",        "l",    "deg",        "bmat",      "step",   "cstype", "curv",   "curv2",  "surf",
    "parm",     "trim", "hole",       "scrv",      "sp",     "end",    "con",    "bevel",  "c_interp",
    "d_interp", "lod",  "shadow_obj", "trace_obj", "ctech",  "stech",  "csh",    "call"};

/// The 0-based indices of a face's corner; `none` where it has no texture coordinate or normal.
struct Corner {
    std::uint32_t position = none;
    std::uint32_t texture = none;
    std::uint32_t normal = none;
};

class ObjReader {
  public:
    ObjReader(std::string_view text, const std::string& file) : cursor_(text, file, true) {}

    Mesh read() {
        while (cursor_.findLine()) {
            const std::string_view keyword = cursor_.word();
            if (!keyword.starts_with('#')) readStatement(keyword);
            cursor_.skipLine();
        }
        return assemble();
    }

  private:
    void readStatement(std::string_view keyword) {
        if (keyword == "v") {
            positions_.push_back(readVector("a vertex coordinate"));
        } else if (keyword == "vn") {
            normals_.push_back(readVector("a normal's component"));
        } else if (keyword == "vt") {
            const auto u = static_cast<float>(cursor_.number("a texture coordinate"));
            const double v = endOfStatement() ? 0.0 : cursor_.number("a texture coordinate");
            texture_.emplace_back(u, 1.0f - static_cast<float>(v));
        } else if (keyword == "f" || keyword == "fo") {
            readFace();
        } else if (std::find(std::begin(passedOver), std::end(passedOver), keyword) == std::end(passedOver)) {
            std::vector<std::string_view> known{"v", "vt", "vn", "f"};
            known.insert(known.end(), std::begin(passedOver), std::end(passedOver));
            cursor_.fail(fmt::format("expected an OBJ statement, found {}{}", quoted(keyword),
                                     suggestion(keyword, known)));
        }
    }

    bool endOfStatement() { return cursor_.atLineEnd() || cursor_.next() == '#'; }

    glm::vec3 readVector(std::string_view what) {
        glm::vec3 vector;
        for (int k = 0; k < 3; ++k) vector[k] = static_cast<float>(cursor_.number(what));
        return vector;
    }

    void readFace() {
        std::uint64_t count = 0;
        std::uint32_t first = 0;
        std::uint32_t previous = 0;
        while (!endOfStatement()) {
            corners_.push_back(readCorner());
            const auto current = static_cast<std::uint32_t>(corners_.size() - 1);
            if (count == 0) first = current;
            if (count >= 2) indices_.insert(indices_.end(), {first, previous, current});
            previous = current;
            ++count;
        }
        if (count < 3) cursor_.fail(fmt::format("a face needs at least 3 corners, found {}", count));
    }

    /// `v`, `v/vt`, `v//vn` or `v/vt/vn`.
    Corner readCorner() {
        const std::string_view word = cursor_.word();
        std::string_view rest = word;
        Corner corner;
        corner.position = readIndex(rest, word, positions_.size(), "v");
        if (rest.starts_with('/')) {
            rest.remove_prefix(1);
            if (!rest.starts_with('/')) corner.texture = readIndex(rest, word, texture_.size(), "vt");
            if (rest.starts_with('/')) {
                rest.remove_prefix(1);
                corner.normal = readIndex(rest, word, normals_.size(), "vn");
            }
        }
        if (!rest.empty()) cursor_.fail(fmt::format("expected a corner like 1/2/3, found {}", quoted(word)));
        return corner;
    }

    std::uint32_t readIndex(std::string_view& rest, std::string_view word, std::size_t count,
                            std::string_view what) {
        std::int64_t index = 0;
        const auto [end, fault] = std::from_chars(rest.data(), rest.data() + rest.size(), index);
        if (fault != std::errc())
            cursor_.fail(fmt::format("expected a corner like 1/2/3, found {}", quoted(word)));
        rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
        const auto known = static_cast<std::int64_t>(count);
        if (index == 0 || index > known || index < -known) {
            cursor_.fail(fmt::format("a face names {} {}, but there are {} so far", what, index, known));
        }
        return static_cast<std::uint32_t>(index > 0 ? index - 1 : known + index);
    }

    /// A vertex for each corner; or, in a file of positions only, for each position. Welding merges equal
    /// ones later.
    Mesh assemble() {
        Mesh mesh;
        if (normals_.empty() && texture_.empty()) {
            mesh.positions = std::move(positions_);
            for (const std::uint32_t corner : indices_) mesh.indices.push_back(corners_[corner].position);
            return mesh;
        }
        for (const Corner& corner : corners_) {
            mesh.positions.push_back(positions_[corner.position]);
            if (!normals_.empty())
                mesh.normals.push_back(corner.normal == none ? glm::vec3(0) : normals_[corner.normal]);
            if (!texture_.empty()) {
                mesh.textureCoordinates.push_back(corner.texture == none ? glm::vec2(0)
                                                                         : texture_[corner.texture]);
            }
        }
        mesh.indices = std::move(indices_);
        return mesh;
    }

    TextCursor cursor_;
    std::vector<glm::vec3> positions_;
    std::vector<glm::vec3> normals_;
    std::vector<glm::vec2> texture_;
    std::vector<Corner> corners_;
    std::vector<std::uint32_t> indices_;  ///< into corners_
};

}  // namespace

Mesh readObj(std::string_view text, const std::string& file) {
    return ObjReader(text, file).read();
}

}  // namespace nephrite::scene
