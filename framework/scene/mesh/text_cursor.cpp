// Words and lines of a text mesh file.
#include "scene/mesh/text_cursor.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace nephrite::scene {
namespace {

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

}  // namespace

std::string quoted(std::string_view word) {
    constexpr std::size_t longest = 40;
    std::string text = "\"";
    for (const char c : word.substr(0, longest)) {
        const auto byte = static_cast<unsigned char>(c);
        text += byte < 0x20 || byte >= 0x7f ? fmt::format("\\x{:02x}", byte) : std::string(1, c);
    }
    return text + (word.size() > longest ? "...\"" : "\"");
}

TextCursor::TextCursor(std::string_view text, std::string file, bool continuations)
    : text_(text), file_(std::move(file)), continuations_(continuations) {}

void TextCursor::skipBlanks() {
    while (!atEnd()) {
        const std::string_view rest = text_.substr(offset_);
        if (continuations_ && (rest.starts_with("\\\n") || rest.starts_with("\\\r\n"))) {
            offset_ += rest[1] == '\n' ? 2 : 3;
            lineStart_ = offset_;
            ++line_;
        } else if (isBlank(rest.front())) {
            ++offset_;
        } else {
            return;
        }
    }
}

bool TextCursor::atLineEnd() {
    skipBlanks();
    wordStart_ = offset_;
    return atEnd() || text_[offset_] == '\n';
}

void TextCursor::skipLine() {
    while (!atLineEnd()) word();
    if (!atEnd()) ++offset_;
    lineStart_ = offset_;
    wordStart_ = offset_;
    ++line_;
}

bool TextCursor::findLine() {
    while (atLineEnd()) {
        if (atEnd()) return false;
        skipLine();
    }
    return true;
}

std::string_view TextCursor::word() {
    if (atLineEnd()) return {};
    const std::size_t start = offset_;
    while (!atEnd() && !isBlank(text_[offset_]) && text_[offset_] != '\n') {
        const std::string_view rest = text_.substr(offset_);
        if (continuations_ && (rest.starts_with("\\\n") || rest.starts_with("\\\r\n")) && offset_ > start)
            break;
        ++offset_;
    }
    return text_.substr(start, offset_ - start);
}

double TextCursor::number(std::string_view what) {
    const std::string_view found = word();
    if (found.empty())
        fail(fmt::format("expected {}, found the end of the {}", what, atEnd() ? "file" : "line"));
    const std::string_view digits = found.starts_with('+') ? found.substr(1) : found;
    double value = 0.0;
    const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool whole = end == digits.data() + digits.size();
    if (fault == std::errc::invalid_argument || !whole) {
        fail(fmt::format("expected {}, found {}", what, quoted(found)));
    }
    // The result of an overflow or underflow is not stored; only the latter is close enough to 0 to accept.
    if (fault == std::errc::result_out_of_range &&
        std::abs(std::strtod(std::string(digits).c_str(), nullptr)) < 1.0) {
        return 0.0;
    }
    constexpr double largest = std::numeric_limits<float>::max();
    if (fault != std::errc() || !(std::abs(value) <= largest)) {
        fail(fmt::format("expected {}, found {}, which is not a finite number", what, quoted(found)));
    }
    return value;
}

void TextCursor::endLine(std::string_view what) {
    if (!atLineEnd()) {
        const std::string_view found = word();
        fail(fmt::format("expected the end of the line after {}, found {}", what, quoted(found)));
    }
    skipLine();
}

SourceLocation TextCursor::where() const {
    return {file_, line_, static_cast<std::uint32_t>(wordStart_ - lineStart_ + 1)};
}

void TextCursor::fail(std::string message) const {
    throw InputError(where(), std::move(message));
}

}  // namespace nephrite::scene
