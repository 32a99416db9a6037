// Checked access to parsed JSON values, and objects read key by key.
#include "text/json.h"

#include <fmt/format.h>

#include <algorithm>

#include "text/source_lines.h"

namespace nephrite::json {
namespace {

std::string expected(std::string_view what, const Value& value) {
    return fmt::format("expected {}, found {}", what, value.describe());
}

}  // namespace

Value::Value(std::shared_ptr<const Document> document, const Json::Value* value)
    : document_(std::move(document)), value_(value) {}

SourceLocation Value::where() const {
    return locate(*document_, start());
}

SourceLocation Value::whereKey() const {
    return locate(*document_, keyStart());
}

std::size_t Value::start() const {
    return static_cast<std::size_t>(value_->getOffsetStart());
}

std::size_t Value::end() const {
    return static_cast<std::size_t>(value_->getOffsetLimit());
}

std::size_t Value::keyStart() const {
    const auto& keys = document_->keys;
    const auto before = [](const KeyPlace& place, std::size_t offset) { return place.value < offset; };
    const auto found = std::lower_bound(keys.begin(), keys.end(), start(), before);
    return found != keys.end() && found->value == start() ? found->key : start();
}

std::string Value::describe() const {
    if (isObject()) return "an object";
    if (isArray()) return size() == 0 ? "an empty array" : fmt::format("an array of {}", size());
    if (isString()) return fmt::format("the string {}", inQuotes(value_->asString()));
    if (isNumber()) return fmt::format("the number {}", sourceText().substr(0, 40));
    return std::string(sourceText());
}

std::string_view Value::sourceText() const {
    return std::string_view(document_->text).substr(start(), end() - start());
}

bool Value::isObject() const {
    return value_->type() == Json::objectValue;
}
bool Value::isArray() const {
    return value_->type() == Json::arrayValue;
}
bool Value::isString() const {
    return value_->type() == Json::stringValue;
}
bool Value::isNumber() const {
    return value_->isNumeric() && !isBool();
}
bool Value::isBool() const {
    return value_->type() == Json::booleanValue;
}
bool Value::isNull() const {
    return value_->type() == Json::nullValue;
}

std::size_t Value::size() const {
    return isObject() || isArray() ? value_->size() : 0;
}

Value Value::at(std::size_t index) const {
    return {document_, &(*value_)[static_cast<Json::ArrayIndex>(index)]};
}

std::optional<Value> Value::find(std::string_view key) const {
    if (!isObject()) return std::nullopt;
    const Json::Value* member = value_->find(key.data(), key.data() + key.size());
    if (member == nullptr) return std::nullopt;
    return Value(document_, member);
}

std::vector<std::pair<std::string, Value>> Value::members() const {
    std::vector<std::pair<std::string, Value>> result;
    if (!isObject()) return result;
    result.reserve(value_->size());
    for (auto member = value_->begin(); member != value_->end(); ++member) {
        result.emplace_back(member.name(), Value(document_, &*member));
    }
    std::sort(result.begin(), result.end(),
              [](const auto& a, const auto& b) { return a.second.start() < b.second.start(); });
    return result;
}

std::optional<double> Value::number(Diagnostics& diagnostics, std::string_view what) const {
    if (isNumber()) return value_->asDouble();
    diagnostics.error(where(), expected(what, *this));
    return std::nullopt;
}

std::optional<std::int64_t> Value::integer(Diagnostics& diagnostics, std::string_view what) const {
    if (isNumber() && value_->isInt64()) return value_->asInt64();
    diagnostics.error(where(), expected(what, *this));
    return std::nullopt;
}

std::optional<bool> Value::boolean(Diagnostics& diagnostics, std::string_view what) const {
    if (isBool()) return value_->asBool();
    diagnostics.error(where(), expected(what, *this));
    return std::nullopt;
}

std::optional<std::string> Value::string(Diagnostics& diagnostics, std::string_view what) const {
    if (isString()) return value_->asString();
    diagnostics.error(where(), expected(what, *this));
    return std::nullopt;
}

std::optional<std::vector<double>> Value::numbers(Diagnostics& diagnostics, std::string_view what,
                                                  std::size_t count) const {
    if (!isArray() || (count != 0 && size() != count)) {
        diagnostics.error(where(), expected(what, *this));
        return std::nullopt;
    }
    std::vector<double> result;
    result.reserve(size());
    for (std::size_t i = 0; i < size(); ++i) {
        const std::optional<double> element = at(i).number(diagnostics, "a number");
        if (!element) return std::nullopt;
        result.push_back(*element);
    }
    return result;
}

ObjectReader::ObjectReader(const Value& value, std::string what, Diagnostics& diagnostics)
    : value_(value), what_(std::move(what)), diagnostics_(diagnostics) {
    if (!value_.isObject()) diagnostics_.error(value_.where(), expected(what_ + " (an object)", value_));
}

ObjectReader::ObjectReader(const Value& value, std::string what, std::span<const Key> keys,
                           Diagnostics& diagnostics)
    : ObjectReader(value, std::move(what), diagnostics) {
    for (const Key& key : keys) {
        if (key.required) {
            required(key.name);
        } else {
            asked_.emplace_back(key.name);
        }
    }
}

std::optional<Value> ObjectReader::optional(std::string_view key) {
    if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.emplace_back(key);
    return value_.find(key);
}

std::optional<Value> ObjectReader::required(std::string_view key) {
    std::optional<Value> member = optional(key);
    if (!member && value_.isObject()) {
        diagnostics_.error(value_.where(), fmt::format("{} needs {}", what_, inQuotes(key)));
    }
    return member;
}

void ObjectReader::finish() {
    for (const auto& [key, member] : value_.members()) {
        if (std::find(asked_.begin(), asked_.end(), key) != asked_.end()) continue;
        diagnostics_.error(member.whereKey(),
                           fmt::format("unknown key {} in {}{}", inQuotes(key), what_,
                                       suggestion(key, std::span<const std::string>(asked_))));
    }
}

}  // namespace nephrite::json
