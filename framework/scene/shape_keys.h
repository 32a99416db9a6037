// The kinds of procedural shapes and of deformations, and their keys: what the readers accept and what the
// schema is made of.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "text/json.h"

namespace nephrite::scene::keys {

/// One of several kinds that a key names, and the keys of an object that is of that kind.
struct Kind {
    std::string_view name;
    std::span<const json::Key> keys;
    std::string_view doc;
};

std::span<const Kind> procedural();   ///< named by "procedural"
std::span<const Kind> deformation();  ///< named by "type", in the order of DeformationKind

std::vector<std::string_view> namesOf(std::span<const Kind> kinds);

}  // namespace nephrite::scene::keys
