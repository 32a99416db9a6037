// See mutations.h. Places are walked with a list, for nothing here may recurse over a file.
#include "schema/mutations.h"

#include <variant>

namespace nephrite::tests {
namespace {

/// The steps from the root to a value: a member's key or an element's index.
using Place = std::vector<std::variant<std::string, Json::ArrayIndex>>;

Json::Value& at(Json::Value& root, const Place& place) {
    Json::Value* value = &root;
    for (const auto& step : place) {
        const std::string* key = std::get_if<std::string>(&step);
        value = key != nullptr ? &(*value)[*key] : &(*value)[std::get<Json::ArrayIndex>(step)];
    }
    return *value;
}

std::string toText(const Place& place) {
    std::string text;
    for (const auto& step : place) {
        const std::string* key = std::get_if<std::string>(&step);
        text += "/" + (key != nullptr ? *key : std::to_string(std::get<Json::ArrayIndex>(step)));
    }
    return text.empty() ? "/" : text;
}

std::vector<Place> placesIn(const Json::Value& root) {
    std::vector<Place> places{{}};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Place place = places[i];
        Json::Value copy = root;
        const Json::Value& value = at(copy, place);
        const auto step = [&](auto to) {
            Place next = place;
            next.emplace_back(std::move(to));
            places.push_back(std::move(next));
        };
        if (value.isObject())
            for (const std::string& key : value.getMemberNames()) step(key);
        if (value.isArray())
            for (Json::ArrayIndex element = 0; element < value.size(); ++element) step(element);
    }
    return places;
}

/// A change of one value, and what it is called.
struct Change {
    std::string name;
    Json::Value value;
};

void addOtherTypes(const Json::Value& value, std::vector<Change>& changes) {
    if (!value.isNull()) changes.push_back({"null", Json::Value()});
    if (!value.isBool()) changes.push_back({"boolean", true});
    if (value.isBool() || !value.isNumeric()) changes.push_back({"number", -1.5});
    if (!value.isString()) changes.push_back({"string", "?"});
    if (!value.isArray()) changes.push_back({"array", Json::Value(Json::arrayValue)});
    if (!value.isObject()) changes.push_back({"object", Json::Value(Json::objectValue)});
}

void addOtherMembers(const Json::Value& value, std::vector<Change>& changes) {
    const auto changed = [&](std::string name, auto change) {
        Json::Value copy = value;
        change(copy);
        changes.push_back({std::move(name), std::move(copy)});
    };
    changed("unknown key", [](Json::Value& object) { object["unheardOf"] = 1; });
    changed("key of a typing error", [](Json::Value& object) { object["9 lives"] = Json::objectValue; });
    for (const std::string& key : value.getMemberNames())
        changed("no " + key, [&](Json::Value& object) { object.removeMember(key); });
}

std::vector<Change> changesOf(const Json::Value& value) {
    std::vector<Change> changes;
    addOtherTypes(value, changes);
    if (value.isString()) changes.push_back({"empty", ""});
    if (value.isString()) changes.push_back({"nonsense", "no such thing"});
    if (value.isNumeric() && !value.isBool())
        for (const double number : {0.0, -1.0, 0.5, -1e300, 1e300}) changes.push_back({"range", number});
    if (value.isObject()) addOtherMembers(value, changes);
    if (value.isArray() && !value.empty()) {
        Json::Value longer = value, shorter = value;
        longer.append(value[0]);
        shorter.resize(value.size() - 1);
        changes.push_back({"longer", std::move(longer)});
        changes.push_back({"shorter", std::move(shorter)});
    }
    return changes;
}

}  // namespace

std::vector<Mutation> mutationsOf(const Json::Value& base) {
    std::vector<Mutation> mutations;
    for (const Place& place : placesIn(base)) {
        Json::Value copy = base;
        for (Change& change : changesOf(at(copy, place))) {
            Json::Value mutant = base;
            at(mutant, place) = std::move(change.value);
            mutations.push_back({toText(place) + ": " + change.name, std::move(mutant)});
        }
    }
    return mutations;
}

}  // namespace nephrite::tests
