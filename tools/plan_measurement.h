// The page of a plan with what a device tells of it: times of passes, and a small picture of each image.
#pragma once

#include <string>

#include "runtime/session.h"

namespace nephrite::tools {

/// Renders a few frames and writes the page of the plan they follow, as text. What `options` say of
/// profiling, reuse and dumps beyond their own is this function's. Throws InputError or RunError.
std::string measuredPage(const runtime::SessionOptions& options);

}  // namespace nephrite::tools
