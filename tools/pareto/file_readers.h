// Reading what suites and sweeps have in common: counts, sizes, names, lists.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "graph/plan.h"
#include "text/json.h"

namespace nephrite::pareto {

/// The longest side of a picture.
inline constexpr std::uint32_t largestSide = 16384;

/// A member that is a whole number from `least` to `most`; without it, `target` stays as it is.
void readCount(json::ObjectReader& object, std::string_view key, std::uint32_t least, std::uint32_t most,
               std::uint32_t& target);

/// The members of an object, or a fault.
std::vector<std::pair<std::string, json::Value>> membersOf(const json::Value& value, std::string_view what,
                                                           Diagnostics& diagnostics);

/// The elements of an array that is not empty, or a fault.
std::vector<json::Value> elementsOf(const json::Value& value, std::string_view what,
                                    Diagnostics& diagnostics);

/// Names become names of files, and words of a table.
void checkName(const std::string& name, std::string_view what, const json::Value& member,
               Diagnostics& diagnostics);

/// [width, height]; nothing and a fault for anything else.
std::optional<graph::Extent> readExtent(const json::Value& value, Diagnostics& diagnostics);

/// A file's name, relative to `folder`; empty and a fault if it is no string.
std::filesystem::path readPath(const json::Value& value, std::string_view what,
                               const std::filesystem::path& folder, Diagnostics& diagnostics);

/// "name" and "doc", which both kinds of file may have; without a name it is the file's.
std::string readName(json::ObjectReader& root, std::string_view what);

}  // namespace nephrite::pareto
