// Reads what a suite says of one method.
#pragma once

#include <filesystem>
#include <string>

#include "pareto/suite.h"

namespace nephrite::pareto {

/// The method that `value` says, which is the member `name` of "methods"; paths start from `folder`. Faults
/// go to `diagnostics`.
Method readMethod(const std::string& name, const json::Value& value, const std::filesystem::path& folder,
                  Diagnostics& diagnostics);

}  // namespace nephrite::pareto
