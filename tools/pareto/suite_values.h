// Values that the readers of a suite share: counts, lists, names.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "text/json.h"
#include "truth/estimator.h"

namespace nephrite::pareto {

/// A whole number into `target`, which stays as it is if there is none.
void readCount(json::ObjectReader& object, std::string_view key, std::uint32_t least, std::uint32_t most,
               std::uint32_t& target);

/// The members of an object, or a fault.
std::vector<std::pair<std::string, json::Value>> membersOf(const json::Value& value, std::string_view what,
                                                           Diagnostics& diagnostics);
/// The elements of an array that is not empty, or a fault.
std::vector<json::Value> elementsOf(const json::Value& value, std::string_view what,
                                    Diagnostics& diagnostics);

/// A fault unless the name can be that of a file and a word of a table. `member` is what has it.
void checkName(const std::string& name, std::string_view what, const json::Value& member,
               Diagnostics& diagnostics);

/// The reference of that name, or a fault with a suggestion.
std::optional<truth::Mode> modeCalled(const std::string& name, const SourceLocation& where,
                                      Diagnostics& diagnostics);

/// A file's name, relative to `folder`; empty after a fault.
std::filesystem::path readPath(const json::Value& value, std::string_view what,
                               const std::filesystem::path& folder, Diagnostics& diagnostics);

}  // namespace nephrite::pareto
