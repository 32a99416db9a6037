// What a pass's ports are to each other: outputs that modify inputs, the domain, and what it is repeated
// over.
#pragma once

#include <optional>
#include <string>

#include "graph/pass_type.h"

namespace nephrite::graph {

/// Looks up OutputPort::modifies. An output takes over the input's buffer element and sort of format where
/// `manifest`, the whole file, does not repeat them. One fault for each output that cannot modify what it
/// names.
void resolveModifies(PassType& type, const json::Value& manifest, Diagnostics& diagnostics);

/// Looks up PassType::domain, which `value` names.
void resolveDomain(PassType& type, const json::Value& value, Diagnostics& diagnostics);

/// A raster pass draws to one level, and to one layer for each view: one fault for each output with more.
void refuseUndrawnParts(const PassType& type, const json::Value& manifest, Diagnostics& diagnostics);

/// Why the pass cannot run once a level of its outputs, or nothing.
struct MipsFault {
    SourceLocation where;  ///< in the manifest
    std::string message;
};
std::optional<MipsFault> whyNotForEachMip(const PassType& type);

}  // namespace nephrite::graph
