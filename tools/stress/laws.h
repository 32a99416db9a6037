// What must hold between pictures: what does not depend on scale, what limits come to, and which way things
// change.
#pragma once

#include <vector>

#include "stress/device.h"
#include "stress/outcome.h"

namespace nephrite::stress {

/// The cases "law/...", rendered with the consistent graphs. Their names say the law; the functions that hold
/// them are in laws.cpp.
std::vector<Case> lawCases(const Place& place);

}  // namespace nephrite::stress
