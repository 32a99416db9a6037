// Following a glTF document's references with checks.
#include "scene/mesh/gltf_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/mesh/gltf_container.h"

namespace nephrite::scene::gltf {
void fail(const json::Value& value, const std::string& message) {
    throw InputError(value.where(), message);
}

std::size_t natural(const json::Value& value, std::size_t highest, std::string_view what) {
    Diagnostics diagnostics;
    const std::optional<std::int64_t> number = value.integer(diagnostics, what);
    diagnostics.throwIfErrors();
    if (*number < 0 || static_cast<std::uint64_t>(*number) > highest) {
        fail(value, fmt::format("expected {} from 0 to {}, found {}", what, highest, *number));
    }
    return static_cast<std::size_t>(*number);
}

std::size_t naturalMember(const json::Value& object, std::string_view key, std::size_t fallback) {
    const std::optional<json::Value> value = object.find(key);
    return value ? natural(*value, largestData, fmt::format("\"{}\"", key)) : fallback;
}

json::Value requiredMember(const json::Value& object, std::string_view key) {
    const std::optional<json::Value> value = object.find(key);
    if (!value) fail(object, fmt::format("\"{}\" is missing", key));
    return *value;
}

std::size_t index(const json::Value& value, std::size_t below, std::string_view what) {
    if (below == 0) fail(value, fmt::format("there are no {}", what));
    return natural(value, below - 1, fmt::format("an index of {}", what));
}

std::optional<std::size_t> findIndex(const json::Value& object, std::string_view key, std::size_t below) {
    const std::optional<json::Value> value = object.find(key);
    if (!value) return std::nullopt;
    if (below == 0) fail(*value, fmt::format("there is nothing that \"{}\" could name", key));
    return natural(*value, below - 1, fmt::format("\"{}\"", key));
}

std::vector<float> numbers(const json::Value& value, std::size_t count, std::string_view what) {
    Diagnostics diagnostics;
    const std::optional<std::vector<double>> read = value.numbers(diagnostics, what, count);
    diagnostics.throwIfErrors();
    std::vector<float> result;
    for (const double number : *read) {
        if (!(std::abs(number) <= 1e15)) fail(value, fmt::format("{} beyond 1e15", what));
        result.push_back(static_cast<float>(number));
    }
    return result;
}

std::string text(const json::Value& value, std::string_view what) {
    Diagnostics diagnostics;
    std::optional<std::string> read = value.string(diagnostics, what);
    diagnostics.throwIfErrors();
    return std::move(*read);
}

std::optional<json::Value> findArray(const json::Value& object, std::string_view key) {
    std::optional<json::Value> value = object.find(key);
    if (value && !value->isArray())
        fail(*value, fmt::format("expected an array, found {}", value->describe()));
    return value;
}

std::optional<json::Value> findObject(const json::Value& object, std::string_view key) {
    std::optional<json::Value> value = object.find(key);
    if (value && !value->isObject())
        fail(*value, fmt::format("expected an object, found {}", value->describe()));
    return value;
}

Document::Document(json::Value root, std::optional<std::string_view> binary, const BufferLoader& loader)
    : root_(std::move(root)) {
    if (!root_.isObject()) fail(root_, fmt::format("expected a glTF document, found {}", root_.describe()));
    std::size_t total = 0;
    for (std::size_t i = 0; i < count("buffers"); ++i) {
        buffers_.push_back(loadBuffer(i, binary, loader));
        total += buffers_.back().size();
        if (total > largestData)
            fail(item("buffers", i), fmt::format("the buffers have more than {} bytes", largestData));
    }
}

std::size_t Document::count(std::string_view name) const {
    const std::optional<json::Value> array = findArray(root_, name);
    return array ? array->size() : 0;
}

json::Value Document::item(std::string_view name, std::size_t i) const {
    json::Value object = findArray(root_, name)->at(i);
    if (!object.isObject()) fail(object, fmt::format("expected an object, found {}", object.describe()));
    return object;
}

std::string Document::loadBuffer(std::size_t i, std::optional<std::string_view> binary,
                                 const BufferLoader& loader) const {
    const json::Value buffer = item("buffers", i);
    const std::size_t length =
        natural(requiredMember(buffer, "byteLength"), largestData, "a buffer's length");
    const std::optional<json::Value> uriValue = buffer.find("uri");
    std::string bytes;
    if (!uriValue) {
        if (i != 0 || !binary)
            fail(buffer, "a buffer without \"uri\", but the file has no binary chunk for it");
        bytes = std::string(binary->substr(0, length));
    } else if (const std::string uri = text(*uriValue, "a URI"); uri.starts_with("data:")) {
        std::optional<std::string> decoded = decodeDataUri(uri);
        if (!decoded) fail(*uriValue, "expected a data URI in base64");
        bytes = std::move(*decoded);
    } else {
        const std::optional<std::string> path = decodePercent(uri);
        if (!path || path->empty() || path->front() == '/' || path->find("://") != std::string::npos ||
            path->find('\0') != std::string::npos) {
            fail(*uriValue, fmt::format("expected a relative path, found {}", uriValue->describe()));
        }
        bytes = loader(*path, uriValue->where());
    }
    if (bytes.size() < length) {
        fail(buffer,
             fmt::format("the buffer is truncated: expected {} bytes, found {}", length, bytes.size()));
    }
    bytes.resize(length);
    return bytes;
}

View Document::view(std::size_t i) const {
    const json::Value object = item("bufferViews", i);
    const std::size_t buffer = index(requiredMember(object, "buffer"), buffers_.size(), "buffers");
    const std::size_t offset = naturalMember(object, "byteOffset", 0);
    const std::size_t length = natural(requiredMember(object, "byteLength"), largestData, "a length");
    const std::size_t size = buffers_[buffer].size();
    if (offset > size || length > size - offset) {
        fail(object,
             fmt::format("bytes {} to {} are beyond the buffer's {} bytes", offset, offset + length, size));
    }
    return {std::string_view(buffers_[buffer]).substr(offset, length),
            naturalMember(object, "byteStride", 0)};
}

}  // namespace nephrite::scene::gltf
