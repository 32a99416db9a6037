// Finding and running commands.
#include "view/commands.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>

#include "graph/value_readers.h"
#include "text/diagnostics.h"

namespace nephrite::view {
namespace {

constexpr std::string_view blanks = " \t\r";

SourceLocation here() {
    return {std::string(commandPlace)};
}

std::string symbolOf(int key) {
    switch (key) {
        case GLFW_KEY_SPACE:
            return "Space";
        case GLFW_KEY_HOME:
            return "Home";
        case GLFW_KEY_TAB:
            return "Tab";
        case GLFW_KEY_F1:
            return "F1";
        case GLFW_KEY_F2:
            return "F2";
        case GLFW_KEY_F3:
            return "F3";
        default:
            return std::string(1, static_cast<char>(key));
    }
}

}  // namespace

std::string keyName(const KeyStroke& key) {
    if (key.key == 0) return {};
    return fmt::format("{}{}{}", key.control ? "Ctrl+" : "", key.shift ? "Shift+" : "", symbolOf(key.key));
}

std::vector<std::string> wordsOf(std::string_view line) {
    std::vector<std::string> words;
    for (;;) {
        const std::size_t start = line.find_first_not_of(blanks);
        if (start == std::string_view::npos) return words;
        line.remove_prefix(start);
        if (words.size() == 1 && words.front() == "set") {
            words.emplace_back(line.substr(0, line.find_last_not_of(blanks) + 1));
            return words;
        }
        const char first = line.front();
        const bool isQuoted = first == '"' || first == '\'';
        const std::size_t end =
            isQuoted ? line.find(first, 1) : std::min(line.find_first_of(blanks), line.size());
        if (end == std::string_view::npos) throw InputError(here(), fmt::format("a {} is not closed", first));
        words.emplace_back(line.substr(isQuoted ? 1 : 0, end - (isQuoted ? 1 : 0)));
        line.remove_prefix(isQuoted ? end + 1 : end);
    }
}

void runCommand(Viewer& viewer, const std::string& line) {
    std::vector<std::string> words = wordsOf(line);
    if (words.empty() || words.front().starts_with('#')) return;
    const std::span<const Command> commands = allCommands();
    const auto found = std::find_if(commands.begin(), commands.end(),
                                    [&](const Command& command) { return command.name == words.front(); });
    if (found == commands.end()) {
        throw InputError(here(), fmt::format("there is no command {}{}", inQuotes(words.front()),
                                             graph::suggestionAmong(words.front(), commands)));
    }
    words.erase(words.begin());
    found->run(viewer, words);
}

}  // namespace nephrite::view
