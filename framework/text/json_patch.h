// What adding and removing a member of an object changes in the text, so that the layout around it goes on.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/json_edit.h"

namespace nephrite::json {

/// Bytes [from, to) of a text give way to `text`.
struct Patch {
    std::size_t from = 0;
    std::size_t to = 0;
    std::string text;
};

/// The text with every patch applied; they must not overlap. Patches at one place come in their order.
std::string patched(std::string_view text, std::vector<Patch> patches);

/// Adds `"key": value` behind the object's last member. `value` is JSON text.
std::vector<Patch> memberAdded(const Value& object, std::string_view key, std::string_view value);

/// Takes away a member, which `object` has, and its comma.
std::vector<Patch> memberRemoved(const Value& member);

}  // namespace nephrite::json
