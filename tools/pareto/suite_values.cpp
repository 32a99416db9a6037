// See suite_values.h.
#include "pareto/suite_values.h"

#include <fmt/format.h>

#include <array>

#include "truth/reference_run.h"

namespace nephrite::pareto {

std::optional<truth::Mode> modeCalled(const std::string& name, const SourceLocation& where,
                                      Diagnostics& diagnostics) {
    if (const auto mode = truth::parseMode(name)) return mode;
    static constexpr std::array<std::string_view, 3> known{"volume", "dipole", "single"};
    diagnostics.error(where,
                      fmt::format("expected a reference (\"volume\", \"dipole\", \"single\"), found {}{}",
                                  inQuotes(name), suggestion(name, known)));
    return std::nullopt;
}

}  // namespace nephrite::pareto
