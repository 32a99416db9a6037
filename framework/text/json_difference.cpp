// See json_difference.h.
#include "text/json_difference.h"

#include <utility>

namespace nephrite::json {
namespace {

/// The values that two documents have at one place.
struct Pair {
    Path path;
    std::optional<Value> before;
    Value after;
};

Path joined(const Path& path, const std::string& step) {
    Path result = path;
    result.push_back(step);
    return result;
}

bool areSame(const std::optional<Value>& a, const std::optional<Value>& b) {
    return a.has_value() == b.has_value() && (!a || a->raw() == b->raw());
}

/// Whether the object in which a change is made was there before and is not any more, or is no object.
bool isPlaceGone(const Path& path, const Value& base, const Value& theirs) {
    Path place;
    for (const std::string& step : path) {
        const std::optional<Value> now = findAt(theirs, place);
        if (!now) return findAt(base, Path(path.begin(), path.end() - 1)).has_value();
        if (!now->isObject()) return true;
        place.push_back(step);
    }
    return false;
}

}  // namespace

std::vector<Change> differences(const Value& before, const Value& after) {
    std::vector<Change> changes;
    std::vector<Pair> pairs{{{}, before, after}};
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Pair pair = std::move(pairs[i]);
        if (pair.before && pair.before->raw() == pair.after.raw()) continue;
        const bool isNew = !pair.before && pair.after.size() > 0;
        if (!pair.after.isObject() || !(isNew || (pair.before && pair.before->isObject()))) {
            changes.push_back({pair.path, std::string(pair.after.sourceText())});
            continue;
        }
        for (const auto& [key, member] : pair.after.members()) {
            pairs.push_back({joined(pair.path, key),
                             pair.before ? pair.before->find(key) : std::optional<Value>(), member});
        }
        if (!pair.before) continue;
        for (const auto& [key, member] : pair.before->members()) {
            if (!pair.after.find(key)) changes.push_back({joined(pair.path, key), std::nullopt});
        }
    }
    return changes;
}

Value changed(const Value& root, const Change& change) {
    return change.json ? setAt(root, change.path, *change.json) : removeAt(root, change.path);
}

Merge merge(const Value& base, const Value& mine, const Value& theirs) {
    Merge merged{theirs, {}, {}};
    for (const Change& change : differences(base, mine)) {
        if (isPlaceGone(change.path, base, theirs)) {
            if (change.json) merged.lost.push_back(change);
            continue;
        }
        const std::optional<Value> now = findAt(theirs, change.path);
        const bool isTheirs = !areSame(now, findAt(base, change.path));
        if (isTheirs && !areSame(now, findAt(mine, change.path))) merged.overruled.push_back(change);
        merged.result = changed(merged.result, change);
    }
    return merged;
}

}  // namespace nephrite::json
