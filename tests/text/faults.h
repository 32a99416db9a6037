// Catching what a reader refuses, with the place of the expected fault marked by @ in the text itself.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/diagnostics.h"

namespace nephrite::tests {

/// The lines of the InputError that `action` throws, or nothing if it throws none.
template<class Action>
std::vector<std::string> faultsOf(Action action) {
    std::vector<std::string> lines;
    try {
        action();
    } catch (const InputError& error) {
        for (const Diagnostic& fault : error.faults()) lines.push_back(toLine(fault));
    }
    return lines;
}

/// A text without its @, and the line and column the @ stood before ("3:14").
struct MarkedText {
    std::string text;
    std::string place;
};
inline MarkedText unmarked(std::string_view marked) {
    const std::size_t at = marked.find('@');
    std::size_t line = 1, column = 1;
    for (const char character : marked.substr(0, at)) {
        column = character == '\n' ? 1 : column + 1;
        line += character == '\n' ? 1 : 0;
    }
    std::string text(marked.substr(0, at));
    if (at != std::string_view::npos) text += marked.substr(at + 1);
    return {std::move(text), std::to_string(line) + ":" + std::to_string(column)};
}

}  // namespace nephrite::tests
