// Rewriting of port calls in the author's GLSL.
#include <algorithm>
#include <array>
#include <cctype>

#include "runtime/interface/node_interface.h"

namespace nephrite::runtime {
namespace {

constexpr std::array<std::string_view, 13> portFunctions{
    "load",       "loadLevel",  "loadLayer", "sample", "sampleLevel", "sampleLayer", "store",
    "storeLevel", "storeLayer", "extent",    "layers", "levels",      "connected"};

bool isWordCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool isSpace(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

std::size_t endOfWord(std::string_view text, std::size_t at) {
    while (at < text.size() && isWordCharacter(text[at])) ++at;
    return at;
}
/// The comment that starts at `at`, or nothing.
std::size_t endOfComment(std::string_view text, std::size_t at) {
    if (text.substr(at, 2) == "//") return std::min(text.find('\n', at), text.size());
    if (text.substr(at, 2) == "/*") {
        const std::size_t end = text.find("*/", at + 2);
        return end == std::string_view::npos ? text.size() : end + 2;
    }
    return at;
}

/// Past spaces, line ends and comments.
std::size_t skipBlank(std::string_view text, std::size_t at) {
    while (at < text.size()) {
        const std::size_t next = isSpace(text[at]) ? at + 1 : endOfComment(text, at);
        if (next == at) break;
        at = next;
    }
    return at;
}

}  // namespace

PortCalls::PortCalls(const graph::PassType& type) {
    for (const auto& port : type.inputs) ports_.push_back(port.name);
    for (const auto& port : type.outputs) ports_.push_back(port.name);
    std::sort(ports_.begin(), ports_.end());
}

std::string PortCalls::rewrite(std::string_view source) const {
    std::string result;
    result.reserve(source.size() + source.size() / 16);
    std::size_t at = 0;
    const auto copyTo = [&](std::size_t end) {
        result.append(source.substr(at, end - at));
        at = end;
    };
    while (at < source.size()) {
        if (const std::size_t end = endOfComment(source, at); end != at) {
            copyTo(end);
            continue;
        }
        if (!isWordCharacter(source[at])) {
            copyTo(at + 1);
            continue;
        }
        const std::size_t wordEnd = endOfWord(source, at);
        const std::string_view word = source.substr(at, wordEnd - at);
        const std::size_t open = skipBlank(source, wordEnd);
        const bool isMember = !result.empty() && result.back() == '.';
        if (isMember || std::find(portFunctions.begin(), portFunctions.end(), word) == portFunctions.end() ||
            open >= source.size() || source[open] != '(') {
            copyTo(wordEnd);
            continue;
        }
        const std::size_t portStart = skipBlank(source, open + 1);
        const std::size_t portEnd = endOfWord(source, portStart);
        const std::size_t next = skipBlank(source, portEnd);
        const std::string_view port = source.substr(portStart, portEnd - portStart);
        const bool endsArgument = next < source.size() && (source[next] == ',' || source[next] == ')');
        if (!endsArgument || !std::binary_search(ports_.begin(), ports_.end(), port)) {
            copyTo(wordEnd);
            continue;
        }
        // What stood between the tokens (spaces, comments, line ends) stays, so that lines keep their
        // numbers.
        result.append(word).append("_").append(port);
        result.append(source.substr(wordEnd, portStart - wordEnd));
        result.append(source.substr(portEnd, next - portEnd));
        at = source[next] == ',' ? next + 1 : next;
    }
    return result;
}

}  // namespace nephrite::runtime
