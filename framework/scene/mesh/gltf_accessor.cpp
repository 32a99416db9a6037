// Reading the values of glTF accessors: strided, sparse, normalised.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "scene/mesh/gltf_document.h"

namespace nephrite::scene::gltf {
namespace {

/// An accessor without a buffer view is all zeros, so its size is not bounded by the file's.
constexpr std::size_t largestZeros = std::size_t{1} << 20;

struct ComponentType {
    std::size_t id;
    std::size_t bytes;
    double largest;  ///< of a normalised integer; 0 for floats
    double (*read)(const char*);
};

template<typename T>
double readAs(const char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
}

constexpr ComponentType componentTypes[] = {
    {5120, 1, 127.0, readAs<std::int8_t>},          {5121, 1, 255.0, readAs<std::uint8_t>},
    {5122, 2, 32767.0, readAs<std::int16_t>},       {5123, 2, 65535.0, readAs<std::uint16_t>},
    {5125, 4, 4294967295.0, readAs<std::uint32_t>}, {5126, 4, 0.0, readAs<float>}};

const ComponentType& componentType(const json::Value& object) {
    const json::Value value = requiredMember(object, "componentType");
    const std::size_t id = natural(value, 100000, "a component type");
    for (const ComponentType& type : componentTypes) {
        if (type.id == id) return type;
    }
    fail(value, fmt::format("unknown component type {}", id));
}

std::size_t componentsOf(std::string_view type) {
    if (type == "SCALAR") return 1;
    if (type == "VEC2") return 2;
    if (type == "VEC3") return 3;
    if (type == "VEC4") return 4;
    return 16;
}

/// Part of a buffer view, `count` elements `stride` bytes apart.
struct Elements {
    std::string_view bytes;
    std::size_t stride = 0;
    std::size_t count = 0;

    const char* at(std::size_t i) const { return bytes.data() + i * stride; }
};

Elements elements(std::string_view view, std::size_t offset, std::size_t stride, std::size_t count,
                  std::size_t elementBytes, const json::Value& where) {
    const bool inside = offset <= view.size() && elementBytes <= view.size() - offset &&
                        (count - 1) <= (view.size() - offset - elementBytes) / stride;
    if (!inside) {
        fail(where,
             fmt::format("{} elements of {} bytes from byte {} do not fit in a buffer view of {} bytes",
                         count, elementBytes, offset, view.size()));
    }
    return {view.substr(offset), stride, count};
}

}  // namespace

/// One accessor while it is read.
class AccessorReader {
  public:
    AccessorReader(const Document& document, std::size_t number, std::string_view type,
                   const json::Value& where)
        : document_(document),
          accessor_(document.item("accessors", number)),
          component_(componentType(accessor_)),
          components_(componentsOf(type)),
          count_(naturalMember(accessor_, "count", 0)) {
        const std::string found = text(requiredMember(accessor_, "type"), "an accessor's type");
        if (found != type) fail(where, fmt::format("expected an accessor of type {}, found {}", type, found));
        if (count_ == 0) fail(accessor_, "an accessor needs a \"count\" of at least 1");
        if (count_ > largestData / (components_ * sizeof(float))) {
            fail(accessor_, fmt::format("{} elements are too many", count_));
        }
    }

    bool isInteger() const { return component_.largest > 0.0; }

    std::vector<double> read() const {
        std::vector<double> values = readDense();
        readSparse(values);
        const std::optional<json::Value> normalized = accessor_.find("normalized");
        if (isInteger() && normalized && normalized->isBool() && normalized->raw().asBool()) {
            for (double& value : values) value = std::max(value / component_.largest, -1.0);
        }
        return values;
    }

  private:
    std::size_t elementBytes() const { return components_ * component_.bytes; }

    void decode(const char* bytes, double* target) const {
        for (std::size_t k = 0; k < components_; ++k)
            target[k] = component_.read(bytes + k * component_.bytes);
    }

    std::vector<double> readDense() const {
        const std::optional<std::size_t> view =
            findIndex(accessor_, "bufferView", document_.count("bufferViews"));
        if (!view && count_ > largestZeros)
            fail(accessor_, fmt::format("{} elements without a buffer view", count_));
        std::vector<double> values(count_ * components_, 0.0);
        if (!view) return values;
        const View bytes = document_.view(*view);
        const std::size_t stride = std::max(elementBytes(), bytes.stride);
        const Elements source = elements(bytes.bytes, naturalMember(accessor_, "byteOffset", 0), stride,
                                         count_, elementBytes(), accessor_);
        for (std::size_t i = 0; i < count_; ++i) decode(source.at(i), &values[i * components_]);
        return values;
    }

    void readSparse(std::vector<double>& values) const {
        const std::optional<json::Value> sparse = findObject(accessor_, "sparse");
        if (!sparse) return;
        const std::size_t replaced = naturalMember(*sparse, "count", 0);
        const std::optional<json::Value> places = findObject(*sparse, "indices");
        const std::optional<json::Value> replacements = findObject(*sparse, "values");
        if (replaced == 0 || replaced > count_ || !places || !replacements) {
            fail(*sparse,
                 "a sparse accessor needs \"count\" within the accessor's, \"indices\" and \"values\"");
        }
        const ComponentType& placeType = componentType(*places);
        if (placeType.largest == 0.0) fail(*places, "expected integer indices");
        const Elements placeElements = sparsePart(*places, placeType.bytes, replaced);
        const Elements valueElements = sparsePart(*replacements, elementBytes(), replaced);
        for (std::size_t i = 0; i < replaced; ++i) {
            const double place = placeType.read(placeElements.at(i));
            if (!(place >= 0.0 && place < static_cast<double>(count_))) {
                fail(*places, fmt::format("sparse index {}, but there are {} elements", place, count_));
            }
            decode(valueElements.at(i), &values[static_cast<std::size_t>(place) * components_]);
        }
    }

    Elements sparsePart(const json::Value& object, std::size_t bytesEach, std::size_t count) const {
        const std::size_t view =
            index(requiredMember(object, "bufferView"), document_.count("bufferViews"), "buffer views");
        return elements(document_.view(view).bytes, naturalMember(object, "byteOffset", 0), bytesEach, count,
                        bytesEach, object);
    }

    const Document& document_;
    json::Value accessor_;
    const ComponentType& component_;
    std::size_t components_;
    std::size_t count_;
};

std::vector<float> Document::floats(std::size_t i, std::string_view type, const json::Value& where) const {
    const std::vector<double> wide = AccessorReader(*this, i, type, where).read();
    std::vector<float> result;
    result.reserve(wide.size());
    for (const double value : wide) {
        if (!(std::abs(value) <= 1e15)) {
            fail(where,
                 fmt::format("accessor {} has the value {}, which is not finite or beyond 1e15", i, value));
        }
        result.push_back(static_cast<float>(value));
    }
    return result;
}

std::vector<std::uint32_t> Document::integers(std::size_t i, std::string_view type,
                                              const json::Value& where) const {
    const AccessorReader reader(*this, i, type, where);
    if (!reader.isInteger()) fail(where, "expected an accessor of integers, found floats");
    const std::vector<double> wide = reader.read();
    std::vector<std::uint32_t> result;
    result.reserve(wide.size());
    for (const double value : wide) {
        if (!(value >= 0.0 && value == std::floor(value)))
            fail(where, fmt::format("expected an index, found {}", value));
        result.push_back(static_cast<std::uint32_t>(value));
    }
    return result;
}

}  // namespace nephrite::scene::gltf
