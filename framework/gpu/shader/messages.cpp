// Reading glslang's log: lines of the form `ERROR: NAME:LINE: 'token' : message`.
#include "gpu/shader/messages.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace nephrite::gpu {
namespace {

constexpr std::string_view errorPrefix = "ERROR: ";

std::optional<std::uint32_t> wholeNumber(std::string_view text) {
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return number;
}

bool take(std::string_view& text, std::string_view word) {
    if (!text.starts_with(word)) return false;
    text.remove_prefix(word.size());
    return true;
}

bool isWordCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::string_view lineOf(std::string_view text, std::uint32_t line) {
    for (std::uint32_t skipped = 1; skipped < line && !text.empty(); ++skipped)
        text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    return text.substr(0, text.find('\n'));
}

/// The first character of a line that is not blank, counted from 1: as near as one can say without a token.
std::uint32_t firstColumn(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t");
    return first == std::string_view::npos ? 1 : static_cast<std::uint32_t>(first + 1);
}

/// Where `token` first stands as a whole word, counted from 1; 0 if the line does not show it.
std::uint32_t columnOf(std::string_view line, std::string_view token) {
    if (token.empty()) return 0;
    for (std::size_t at = line.find(token); at != std::string_view::npos; at = line.find(token, at + 1)) {
        const std::size_t end = at + token.size();
        const bool startsWord = at == 0 || !isWordCharacter(line[at - 1]) || !isWordCharacter(token.front());
        const bool endsWord =
            end == line.size() || !isWordCharacter(line[end]) || !isWordCharacter(token.back());
        if (startsWord && endsWord) return static_cast<std::uint32_t>(at + 1);
    }
    return 0;
}

struct Message {
    std::string_view token;
    std::string text;
};

/// Splits `'token' : text`; an empty token leaves only the text, an #include the includer's words.
Message splitToken(std::string_view message) {
    const std::size_t separator = message.find("' : ");
    if (!message.starts_with('\'') || separator == std::string_view::npos) return {{}, std::string(message)};
    const std::string_view token = message.substr(1, separator - 1);
    std::string_view text = message.substr(separator + 4);
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    if (token == "#include") text = text.substr(0, text.find(" for header name: "));
    if (token.empty() || token == "#include") return {token, std::string(text)};
    return {token, std::string("'").append(token).append("': ").append(text)};
}

/// `NAME:LINE: message`, or nothing if the text is not of that form.
std::optional<Diagnostic> located(std::string_view text, const SourceFiles& files) {
    const std::size_t messageColon = text.find(": ");
    if (messageColon == std::string_view::npos) return std::nullopt;
    const std::string_view place = text.substr(0, messageColon);
    const std::size_t lineColon = place.rfind(':');
    if (lineColon == std::string_view::npos) return std::nullopt;
    const std::optional<std::uint32_t> line = wholeNumber(place.substr(lineColon + 1));
    if (!line) return std::nullopt;
    Message message = splitToken(text.substr(messageColon + 2));
    const std::string_view file = place.substr(0, lineColon);
    const std::optional<std::uint32_t> index = wholeNumber(file);
    if (!index || *index >= files.texts().size())
        return Diagnostic{{std::string(file), *line, 0}, std::move(message.text)};
    const SourceText& source = files.texts()[*index];
    const std::string_view shown = lineOf(source.text, *line);
    const std::uint32_t column = columnOf(shown, message.token);
    return Diagnostic{{source.name, *line, column == 0 ? firstColumn(shown) : column},
                      std::move(message.text)};
}

/// The lines that only sum up, once there is a fault that says more.
bool isSummary(std::string_view text) {
    return text.find("compilation terminated") != std::string_view::npos ||
           text.find("compilation errors.") != std::string_view::npos;
}

}  // namespace

std::vector<Diagnostic> faultsOf(std::string_view log, const SourceFiles& files, const std::string& name) {
    std::vector<Diagnostic> faults;
    const std::string whole(log);
    while (!log.empty()) {
        const std::size_t end = std::min(log.find('\n'), log.size() - 1);
        std::string_view line = log.substr(0, end);
        log.remove_prefix(end + 1);
        if (!take(line, errorPrefix) || isSummary(line)) continue;
        // glslang stops reading at the first fault in the text; what it says after it is about the text
        // broken off.
        if (auto fault = located(line, files)) return {std::move(*fault)};
        faults.push_back({{name, 0, 0}, std::string(line)});
    }
    if (faults.empty()) faults.push_back({{name, 0, 0}, "the shader cannot be compiled: " + whole});
    return faults;
}

}  // namespace nephrite::gpu
