// See suite_values.h.
#include "pareto/suite_values.h"

#include <fmt/format.h>

#include <array>

#include "graph/value_readers.h"
#include "truth/reference_run.h"

namespace nephrite::pareto {

using json::ObjectReader;
using json::Value;

void readCount(ObjectReader& object, std::string_view key, std::uint32_t least, std::uint32_t most,
               std::uint32_t& target) {
    const auto value = object.optional(key);
    if (!value) return;
    const std::string what = fmt::format("a whole number from {} to {}", least, most);
    const auto number = value->integer(object.diagnostics(), what);
    if (!number) return;
    if (*number < least || *number > most)
        object.diagnostics().error(value->where(),
                                   fmt::format("expected {}, found {}", what, value->describe()));
    else
        target = static_cast<std::uint32_t>(*number);
}

std::vector<std::pair<std::string, Value>> membersOf(const Value& value, std::string_view what,
                                                     Diagnostics& diagnostics) {
    if (!value.isObject())
        diagnostics.error(value.where(),
                          fmt::format("expected an object of {}, found {}", what, value.describe()));
    return value.members();
}

std::vector<Value> elementsOf(const Value& value, std::string_view what, Diagnostics& diagnostics) {
    std::vector<Value> elements;
    if (value.isArray())
        for (std::size_t i = 0; i < value.size(); ++i) elements.push_back(value.at(i));
    if (elements.empty())
        diagnostics.error(value.where(),
                          fmt::format("expected an array of {}, found {}", what, value.describe()));
    return elements;
}

void checkName(const std::string& name, std::string_view what, const Value& member,
               Diagnostics& diagnostics) {
    if (graph::isIdentifier(name, true)) return;
    diagnostics.error(member.whereKey(),
                      fmt::format("{} cannot be called {}: expected letters, digits, - and _, no digit first",
                                  what, inQuotes(name)));
}

std::optional<truth::Mode> modeCalled(const std::string& name, const SourceLocation& where,
                                      Diagnostics& diagnostics) {
    if (const auto mode = truth::parseMode(name)) return mode;
    static constexpr std::array<std::string_view, 3> known{"volume", "dipole", "single"};
    diagnostics.error(where,
                      fmt::format("expected a reference (\"volume\", \"dipole\", \"single\"), found {}{}",
                                  inQuotes(name), suggestion(name, known)));
    return std::nullopt;
}

std::filesystem::path readPath(const Value& value, std::string_view what, const std::filesystem::path& folder,
                               Diagnostics& diagnostics) {
    const auto file = value.string(diagnostics, what);
    return file ? (folder / *file).lexically_normal() : std::filesystem::path();
}

}  // namespace nephrite::pareto
