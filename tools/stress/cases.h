// The stress list: everything that tends to break, as named cases that can be run one by one.
#pragma once

#include <string>
#include <vector>

#include "stress/device.h"
#include "stress/outcome.h"

namespace nephrite::stress {

/// Every case, in groups "device", "law", "profile", "photons" and "reference".
std::vector<Case> allCases(const Place& place);

/// Runs a case; an exception becomes a failure.
Outcome run(const Case& item);

}  // namespace nephrite::stress
