// What the readers of a suite share beside what they share with those of sweeps.
#pragma once

#include <optional>
#include <string>

#include "pareto/file_readers.h"
#include "truth/estimator.h"

namespace nephrite::pareto {

/// The reference of that name, or a fault with a suggestion.
std::optional<truth::Mode> modeCalled(const std::string& name, const SourceLocation& where,
                                      Diagnostics& diagnostics);

}  // namespace nephrite::pareto
