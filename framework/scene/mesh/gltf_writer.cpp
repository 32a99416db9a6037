// The plain GLB: JSON text and one binary chunk.
#include "scene/mesh/gltf_writer.h"

#include <json/writer.h>

#include <vector>

#include "scene/mesh/gltf_container.h"

namespace nephrite::scene::gltf {
namespace {

constexpr int unsignedShort = 5123;
constexpr int unsignedInt = 5125;
constexpr int floatingPoint = 5126;

}  // namespace

Writer::Writer() {
    document_["asset"]["version"] = "2.0";
}

Json::UInt Writer::addAccessor(const void* data, std::size_t bytes, int componentType, std::string_view type,
                               std::size_t count) {
    Json::Value view;
    view["buffer"] = 0;
    view["byteOffset"] = static_cast<Json::UInt64>(binary_.size());
    view["byteLength"] = static_cast<Json::UInt64>(bytes);
    binary_.append(static_cast<const char*>(data), bytes);
    while (binary_.size() % 4 != 0) binary_.push_back('\0');
    Json::Value accessor;
    accessor["bufferView"] = document_["bufferViews"].size();
    accessor["componentType"] = componentType;
    accessor["count"] = static_cast<Json::UInt64>(count);
    accessor["type"] = std::string(type);
    document_["bufferViews"].append(view);
    document_["accessors"].append(accessor);
    return document_["accessors"].size() - 1;
}

Json::UInt Writer::addFloats(std::span<const float> values, std::string_view type, std::size_t components) {
    return addAccessor(values.data(), values.size_bytes(), floatingPoint, type, values.size() / components);
}

Json::UInt Writer::addIndices(std::span<const std::uint32_t> values) {
    return addAccessor(values.data(), values.size_bytes(), unsignedInt, "SCALAR", values.size());
}

Json::UInt Writer::addJoints(std::span<const std::uint32_t> values) {
    const std::vector<std::uint16_t> narrow(values.begin(), values.end());
    return addAccessor(narrow.data(), narrow.size() * sizeof(std::uint16_t), unsignedShort, "VEC4",
                       narrow.size() / 4);
}

std::string Writer::finish() {
    Json::Value buffer;
    buffer["byteLength"] = static_cast<Json::UInt64>(binary_.size());
    document_["buffers"].append(buffer);
    Json::StreamWriterBuilder builder;
    builder["indentation"] = "";
    return makeGlb(Json::writeString(builder, document_), std::move(binary_));
}

}  // namespace nephrite::scene::gltf
