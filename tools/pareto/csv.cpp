// Comma-separated values.
#include "pareto/csv.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace nephrite::pareto {

std::string csvField(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return quoted + "\"";
}

std::string csvField(double value) {
    return std::isfinite(value) ? fmt::format("{:.17g}", value) : std::string();
}

std::string csvTime(double ms) {
    return std::isfinite(ms) ? fmt::format("{:.6f}", ms) : std::string();
}

std::string CsvLine::text() const {
    return fmt::format("{}\n", fmt::join(fields_, ","));
}

}  // namespace nephrite::pareto
