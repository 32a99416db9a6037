// Reading a scene's {"procedural": NAME, ...}.
#include <fmt/format.h>

#include <vector>

#include "scene/mesh/procedural.h"

namespace nephrite::scene {
namespace {

constexpr std::string_view names[] = {"sphere", "slab", "teapot", "cube", "plane", "torus"};

class Reader {
  public:
    Reader(const json::Value& value, Diagnostics& diagnostics)
        : object_(value, "a procedural mesh", diagnostics), errorsBefore_(diagnostics.errors().size()) {}

    std::optional<Mesh> read() {
        const std::optional<json::Value> value = object_.required("procedural");
        const std::optional<std::string> name =
            value ? value->string(object_.diagnostics(), "the name of a procedural mesh") : std::nullopt;
        if (!name) return std::nullopt;
        if (*name == "sphere") return sphereMesh();
        if (*name == "slab") return slabMesh();
        if (*name == "teapot") return teapotMesh();
        if (*name == "cube") return cubeMesh();
        if (*name == "plane") return planeMesh();
        if (*name == "torus") return torusMesh();
        object_.diagnostics().error(
            value->where(), fmt::format("unknown procedural mesh \"{}\"{}", *name, suggestion(*name, names)));
        return std::nullopt;
    }

  private:
    std::optional<Mesh> sphereMesh() {
        const float radius = length("radius", 1.0);
        if (!finish()) return std::nullopt;
        return sphere(radius);
    }

    std::optional<Mesh> slabMesh() {
        object_.required("size");
        const std::vector<float> size = lengths("size", 3);
        if (!finish()) return std::nullopt;
        return slab({size[0], size[1], size[2]});
    }

    std::optional<Mesh> teapotMesh() {
        if (!finish()) return std::nullopt;
        return teapot();
    }

    std::optional<Mesh> cubeMesh() {
        const float size = length("size", 1.0);
        if (!finish()) return std::nullopt;
        return slab(glm::vec3(size));
    }

    std::optional<Mesh> planeMesh() {
        const std::vector<float> size = lengths("size", 2);
        if (!finish()) return std::nullopt;
        return plane({size[0], size[1]});
    }

    std::optional<Mesh> torusMesh() {
        const float radius = length("radius", 1.0);
        const float tube = length("tube", 0.25);
        if (!finish()) return std::nullopt;
        return torus(radius, tube);
    }

    bool finish() {
        object_.finish();
        return object_.diagnostics().errors().size() == errorsBefore_;
    }

    bool allowed(double length) const { return length >= shortestLength && length <= longestLength; }

    void refuse(const json::Value& value, std::string_view key) {
        object_.diagnostics().error(
            value.where(), fmt::format("\"{}\" must be from {:g} to {:g}, found {}", key, shortestLength,
                                       longestLength, value.sourceText()));
    }

    float length(std::string_view key, double fallback) {
        const std::optional<json::Value> value = object_.optional(key);
        if (!value) return static_cast<float>(fallback);
        const std::optional<double> number = value->number(object_.diagnostics(), "a length");
        if (number && !allowed(*number)) refuse(*value, key);
        return static_cast<float>(number.value_or(fallback));
    }

    std::vector<float> lengths(std::string_view key, std::size_t count) {
        std::vector<float> result(count, 1.0f);
        const std::optional<json::Value> value = object_.optional(key);
        if (!value) return result;
        const auto numbers = value->numbers(object_.diagnostics(), fmt::format("{} lengths", count), count);
        if (!numbers) return result;
        for (std::size_t i = 0; i < count; ++i) {
            if (!allowed((*numbers)[i])) {
                refuse(*value, key);
                break;
            }
            result[i] = static_cast<float>((*numbers)[i]);
        }
        return result;
    }

    json::ObjectReader object_;
    std::size_t errorsBefore_;
};

}  // namespace

std::optional<Mesh> readProcedural(const json::Value& value, Diagnostics& diagnostics) {
    return Reader(value, diagnostics).read();
}

}  // namespace nephrite::scene
