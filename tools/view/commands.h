// Everything the viewer can be told, by key, in its command line or from a script: one table of all of them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nephrite::view {

class Viewer;

/// A key, with Ctrl or Shift or without.
struct KeyStroke {
    int key = 0;  ///< GLFW's number; 0: no key
    bool control = false;
    bool shift = false;
};

struct Command {
    std::string_view name;
    std::string_view arguments;  ///< for the help, `[X]` may be left out
    KeyStroke key;               ///< runs it without arguments
    std::string_view doc;
    /// Throws InputError if the arguments are wrong, and what it does may throw.
    void (*run)(Viewer& viewer, const std::vector<std::string>& arguments);
};

/// Where a fault is that lies in a command's own words.
constexpr std::string_view commandPlace = "command";

std::span<const Command> allCommands();
/// "Ctrl+S", or nothing.
std::string keyName(const KeyStroke& key);

/// Words of a line, divided by blanks; a part between '...' or "..." is one word. The last word of a line
/// that starts with `set` goes on to the end. Throws InputError if a quote is not closed.
std::vector<std::string> wordsOf(std::string_view line);

/// Runs `NAME ARGUMENTS...`; nothing if the line is empty or starts with #. Throws InputError with a
/// suggestion if there is no such command.
void runCommand(Viewer& viewer, const std::string& line);

}  // namespace nephrite::view
