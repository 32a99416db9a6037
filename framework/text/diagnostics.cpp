// How faults are worded and printed, and which known word a misspelt one was probably meant to be.
#include "text/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace nephrite {
namespace {

std::string joinedLines(const std::vector<Diagnostic>& faults) {
    std::string lines;
    for (const Diagnostic& fault : faults) {
        if (!lines.empty()) lines += '\n';
        lines += toLine(fault);
    }
    return lines;
}

char lowerCase(char character) {
    return character >= 'A' && character <= 'Z' ? static_cast<char>(character - 'A' + 'a') : character;
}

/// Insertions, deletions, substitutions and swaps of neighbours that turn `a` into `b`, letter case left out
/// (optimal string alignment distance); `bound + 1` if it takes more than `bound`.
std::size_t editDistance(std::string_view a, std::string_view b, std::size_t bound) {
    const std::size_t difference = a.size() > b.size() ? a.size() - b.size() : b.size() - a.size();
    if (difference > bound) return bound + 1;
    std::vector<std::size_t> beforeLast(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lowerCase(a[i - 1]) == lowerCase(b[j - 1]);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
            const bool swapped = i > 1 && j > 1 && lowerCase(a[i - 1]) == lowerCase(b[j - 2]) &&
                                 lowerCase(a[i - 2]) == lowerCase(b[j - 1]);
            if (swapped) row[j] = std::min(row[j], beforeLast[j - 2] + 1);
        }
        std::swap(beforeLast, last);
        std::swap(last, row);
    }
    return std::min(last[b.size()], bound + 1);
}

template<class Word>
std::string nearest(std::string_view found, std::span<const Word> known) {
    constexpr std::size_t longestWorthComparing = 64;
    if (found.empty() || found.size() > longestWorthComparing) return {};
    std::size_t closest = std::max<std::size_t>(1, found.size() / 3) + 1;
    std::string_view best;
    for (const Word& word : known) {
        if (closest == 0) break;
        const std::size_t distance = editDistance(found, word, closest - 1);
        if (distance >= closest) continue;
        closest = distance;
        best = word;
    }
    return best.empty() ? std::string() : fmt::format(", did you mean {}?", inQuotes(best));
}

}  // namespace

std::string toLine(const Diagnostic& diagnostic, std::string_view severity) {
    const SourceLocation& where = diagnostic.where;
    std::string line = where.line == 0 ? fmt::format("{}: {}: {}", where.file, severity, diagnostic.message)
                                       : fmt::format("{}:{}:{}: {}: {}", where.file, where.line, where.column,
                                                     severity, diagnostic.message);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return line;
}

InputError::InputError(std::vector<Diagnostic> faults)
    : std::runtime_error(joinedLines(faults)), faults_(std::move(faults)) {}

InputError::InputError(SourceLocation where, std::string message)
    : InputError(std::vector<Diagnostic>{{std::move(where), std::move(message)}}) {}

void Diagnostics::error(SourceLocation where, std::string message) {
    errors_.push_back({std::move(where), std::move(message)});
}

void Diagnostics::warning(SourceLocation where, std::string message) {
    warnings_.push_back({std::move(where), std::move(message)});
}

void Diagnostics::throwIfErrors() const {
    if (hasErrors()) throw InputError(errors_);
}

std::string inQuotes(std::string_view text) {
    constexpr std::size_t longest = 60;
    const bool cut = text.size() > longest;
    if (cut) {
        std::size_t end = longest;
        while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
        text = text.substr(0, end);
    }
    std::string result = "\"";
    for (const char character : text) {
        const auto byte = static_cast<unsigned char>(character);
        if (character == '\n') {
            result += "\\n";
        } else if (character == '\t') {
            result += "\\t";
        } else if (byte < 0x20 || byte == 0x7F) {
            result += fmt::format("\\u{:04x}", byte);
        } else {
            result += character;
        }
    }
    return result + (cut ? "...\"" : "\"");
}

std::string suggestion(std::string_view found, std::span<const std::string_view> known) {
    return nearest(found, known);
}

std::string suggestion(std::string_view found, std::span<const std::string> known) {
    return nearest(found, known);
}

}  // namespace nephrite
