// Pass types described for people and for programs: `nephrite passes [TYPE] [--json]`.
#pragma once

#include <string>

#include "graph/pass_type.h"

namespace nephrite::graph {

/// Everything the manifest says, as indented text.
std::string describePass(const PassType& type);
/// The same as a JSON object: name, kind, doc, shader, inputs, outputs, parameters, skipWhen.
std::string describePassAsJson(const PassType& type);

/// One line a pass type: name, kind and the first sentence of its doc. The faults of broken manifests go to
/// `diagnostics`.
std::string listPasses(const PassLibrary& library, Diagnostics& diagnostics);
/// A JSON array of describePassAsJson() for every pass type that can be read.
std::string listPassesAsJson(const PassLibrary& library, Diagnostics& diagnostics);

}  // namespace nephrite::graph
