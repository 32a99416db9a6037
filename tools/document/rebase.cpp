// See rebase.h.
#include "document/rebase.h"

#include <fmt/format.h>

#include <optional>

namespace nephrite::document {
namespace {

std::string whyLost(const json::Change& change) {
    return fmt::format("{}: what it was set in is gone", json::toText(change.path));
}

/// The first fault of `root`, or nothing if it links.
std::optional<std::string> faultOf(const json::Value& root,
                                   const std::function<void(const json::Value&)>& link) {
    try {
        link(root);
        return std::nullopt;
    } catch (const InputError& error) {
        return error.faults().front().message;
    }
}

}  // namespace

Rebased rebased(const json::Value& base, const json::Value& mine, const json::Value& theirs,
                const std::function<void(const json::Value&)>& link) {
    const json::Merge merge = json::merge(base, mine, theirs);
    Rebased result{merge.result, {true, {}, {}}};
    for (const json::Change& change : merge.overruled)
        result.report.overruled.push_back(json::toText(change.path));
    for (const json::Change& change : merge.lost) result.report.dropped.push_back(whyLost(change));
    if (!faultOf(result.root, link)) return result;

    result.root = theirs;
    for (const json::Change& change : json::differences(theirs, merge.result)) {
        json::Value next = json::changed(result.root, change);
        if (const auto fault = faultOf(next, link)) {
            result.report.dropped.push_back(fmt::format("{}: {}", json::toText(change.path), *fault));
        } else {
            result.root = std::move(next);
        }
    }
    return result;
}

}  // namespace nephrite::document
