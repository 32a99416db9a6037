// Another program, run for what it prints.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace nephrite::pareto {

/// Standard output of `arguments[0]`, looked up in PATH, given the rest; nothing if there is no such program.
/// Its standard error is ours. Throws RunError if it fails.
std::optional<std::string> outputOf(const std::vector<std::string>& arguments);

}  // namespace nephrite::pareto
