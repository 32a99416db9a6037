// Readers of suites' and sweeps' common parts.
#include "pareto/file_readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graph/value_readers.h"

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

std::optional<graph::Extent> readExtent(const Value& value, Diagnostics& diagnostics) {
    const auto numbers = value.numbers(diagnostics, "[width, height]", 2);
    if (!numbers) return std::nullopt;
    const auto isSide = [](double side) {
        return side >= 1 && side <= largestSide && side == std::floor(side);
    };
    if (std::all_of(numbers->begin(), numbers->end(), isSide))
        return graph::Extent{static_cast<std::uint32_t>((*numbers)[0]),
                             static_cast<std::uint32_t>((*numbers)[1])};
    diagnostics.error(value.where(), fmt::format("expected whole numbers from 1 to {}, found {}", largestSide,
                                                 value.sourceText()));
    return std::nullopt;
}

std::filesystem::path readPath(const Value& value, std::string_view what, const std::filesystem::path& folder,
                               Diagnostics& diagnostics) {
    const auto file = value.string(diagnostics, what);
    return file ? (folder / *file).lexically_normal() : std::filesystem::path();
}

std::string readName(ObjectReader& root, std::string_view what) {
    Diagnostics& diagnostics = root.diagnostics();
    if (const auto doc = root.optional("doc")) doc->string(diagnostics, "a string");
    const auto name = root.optional("name");
    if (!name) return std::filesystem::path(root.value().where().file).stem().string();
    const std::string text = name->string(diagnostics, "a string").value_or("");
    if (!graph::isIdentifier(text, true) && name->isString())
        diagnostics.error(name->where(),
                          fmt::format("{}'s name has letters, digits, - and _, no digit first", what));
    return text;
}

}  // namespace nephrite::pareto
