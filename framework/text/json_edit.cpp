// See json_edit.h. Every result is parsed again and held against the same edit of the parsed tree.
#include "text/json_edit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <stdexcept>
#include <utility>

#include "text/json_patch.h"

namespace nephrite::json {
namespace {

std::optional<std::size_t> asIndex(const std::string& step) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(step.data(), step.data() + step.size(), index);
    if (error != std::errc() || end != step.data() + step.size()) return std::nullopt;
    return index;
}

std::optional<Value> childOf(const Value& value, const std::string& step) {
    if (value.isObject()) return value.find(step);
    const auto index = value.isArray() ? asIndex(step) : std::nullopt;
    if (!index || *index >= value.size()) return std::nullopt;
    return value.at(*index);
}

/// The same step in a tree that has it, or in an object that may not.
Json::Value& childOf(Json::Value& value, const std::string& step) {
    if (value.isArray()) return value[static_cast<Json::ArrayIndex>(*asIndex(step))];
    return value[step];
}

/// What turns one value into another of the same document's.
std::vector<Patch> replaced(const Value& before, const Value& after) {
    std::vector<Patch> patches;
    std::vector<std::pair<Value, Value>> pending{{before, after}};
    while (!pending.empty()) {
        const auto [old, next] = std::move(pending.back());
        pending.pop_back();
        if (old.raw() == next.raw()) continue;
        if (old.isArray() && next.isArray() && old.size() == next.size()) {
            for (std::size_t i = 0; i < old.size(); ++i) pending.emplace_back(old.at(i), next.at(i));
        } else {
            patches.push_back({old.start(), old.end(), std::string(next.sourceText())});
        }
    }
    return patches;
}

/// `json` inside the objects that the steps of `path` from `first` on name.
std::string nested(const Path& path, std::size_t first, std::string_view json) {
    std::string text(json);
    for (std::size_t i = path.size(); i > first; --i)
        text = fmt::format("{{{}: {}}}", jsonString(path[i - 1]), text);
    return text;
}

Value edited(const Value& root, std::vector<Patch> patches, const Json::Value& expected) {
    const Document& document = root.document();
    Value result = parse(patched(document.text, std::move(patches)), document.file);
    if (result.raw() != expected) throw std::logic_error("an edit of a JSON text changed something else");
    return result;
}

}  // namespace

std::string toText(const Path& path) {
    return fmt::format("{}", fmt::join(path, "."));
}

std::optional<Value> findAt(const Value& root, const Path& path) {
    std::optional<Value> value = root;
    for (const std::string& step : path) {
        value = childOf(*value, step);
        if (!value) return std::nullopt;
    }
    return value;
}

Value setAt(const Value& root, const Path& path, std::string_view json) {
    const Value replacement = parse(std::string(json), toText(path));
    Json::Value expected = root.raw();
    Json::Value* target = &expected;
    Value value = root;
    for (std::size_t depth = 0; depth < path.size(); ++depth) {
        const std::optional<Value> child = childOf(value, path[depth]);
        if (!child && !value.isObject()) {
            throw InputError(value.where(), fmt::format("expected something with {} in it, found {}",
                                                        inQuotes(path[depth]), value.describe()));
        }
        target = &childOf(*target, path[depth]);
        if (!child) {
            for (std::size_t i = depth + 1; i < path.size(); ++i) target = &(*target)[path[i]];
            *target = replacement.raw();
            const std::string text = nested(path, depth + 1, replacement.sourceText());
            return edited(root, memberAdded(value, path[depth], text), expected);
        }
        value = *child;
    }
    *target = replacement.raw();
    return edited(root, replaced(value, replacement), expected);
}

Value removeAt(const Value& root, const Path& path) {
    if (path.empty()) throw std::invalid_argument("a document cannot be removed from itself");
    const std::optional<Value> parent = findAt(root, Path(path.begin(), path.end() - 1));
    if (!parent) return root;
    if (parent->isArray())
        throw InputError(parent->where(), fmt::format("{} is an element of an array", toText(path)));
    const std::optional<Value> member = parent->find(path.back());
    if (!member) return root;
    Json::Value expected = root.raw();
    Json::Value* object = &expected;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) object = &childOf(*object, path[i]);
    object->removeMember(path.back());
    return edited(root, memberRemoved(*member), expected);
}

}  // namespace nephrite::json
