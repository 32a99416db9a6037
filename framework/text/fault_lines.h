// What was thrown, as the lines a user reads.
#pragma once

#include <exception>
#include <string>
#include <vector>

namespace nephrite {

/// A line for each fault of an InputError; one line for anything else, with the program's name where it names
/// no file of its own.
std::vector<std::string> linesOf(const std::exception& error);

}  // namespace nephrite
