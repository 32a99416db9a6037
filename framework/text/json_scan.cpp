// See json_scan.h. The grammar of strings, numbers and escapes is RFC 8259's; comments are JavaScript's.
#include "text/json_scan.h"

#include <fmt/format.h>

#include <array>

#include "text/utf8.h"

namespace nephrite::json {
namespace {

constexpr std::size_t none = std::string_view::npos;

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}
bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$';
}
bool isSpace(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}
bool isNumberStart(char c) {
    return isDigit(c) || c == '-' || c == '+' || c == '.';
}
bool isNumberPart(char c) {
    return isNumberStart(c) || isLetter(c);
}

/// -?(0|[1-9][0-9]*)(\.[0-9]+)?([eE][+-]?[0-9]+)?
bool isNumber(std::string_view token) {
    std::size_t at = 0;
    const auto skipDigits = [&] {
        const std::size_t start = at;
        while (at < token.size() && isDigit(token[at])) ++at;
        return at - start;
    };
    if (at < token.size() && token[at] == '-') ++at;
    const bool leadingZero = at < token.size() && token[at] == '0';
    const std::size_t whole = skipDigits();
    if (whole == 0 || (leadingZero && whole > 1)) return false;
    if (at < token.size() && token[at] == '.') {
        ++at;
        if (skipDigits() == 0) return false;
    }
    if (at < token.size() && (token[at] == 'e' || token[at] == 'E')) {
        ++at;
        if (at < token.size() && (token[at] == '+' || token[at] == '-')) ++at;
        if (skipDigits() == 0) return false;
    }
    return at == token.size();
}

class Scanner {
  public:
    explicit Scanner(std::string_view text) : text_(text) { scan_.bare = text; }

    Scan run() {
        at_ = byteOrderMarkLength(text_);
        blank(0, at_);
        while (!scan_.fault && at_ < text_.size()) token();
        return std::move(scan_);
    }

  private:
    char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
    void fail(std::size_t offset, std::string message) {
        scan_.fault = TextFault{offset, std::move(message)};
    }

    void blank(std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            if (text_[i] != '\n' && text_[i] != '\r') scan_.bare[i] = ' ';
        }
    }

    void token() {
        const char c = text_[at_];
        if (isSpace(c)) {
            ++at_;
        } else if (c == '/') {
            comment();
        } else if (c == '"') {
            valueStarts();
            string();
        } else if (isNumberStart(c)) {
            valueStarts();
            number();
        } else if (isLetter(c)) {
            valueStarts();
            word();
        } else {
            punctuation(c);
        }
    }

    /// If a key and a colon came before, the value that starts here is theirs.
    void valueStarts() {
        if (keyOfNextValue_ != none) scan_.keys.push_back({at_, keyOfNextValue_});
        keyOfNextValue_ = none;
    }

    void punctuation(char c) {
        if (c == '{' || c == '[') {
            valueStarts();
            if (++depth_ > maximumDepth) {
                return fail(at_,
                            fmt::format("objects and arrays are nested deeper than {} levels", maximumDepth));
            }
        } else if (c == '}' || c == ']') {
            --depth_;
        } else if (c == ':') {
            keyOfNextValue_ = lastString_;
        } else if (c != ',') {
            return fail(at_, fmt::format("unexpected character, found {}", describeTextAt(text_, at_)));
        }
        ++at_;
    }

    void comment() {
        const std::size_t start = at_;
        if (peek(1) == '/') {
            const std::size_t end = text_.find_first_of("\r\n", at_);
            at_ = end == none ? text_.size() : end;
        } else if (peek(1) == '*') {
            const std::size_t end = text_.find("*/", at_ + 2);
            if (end == none) return fail(start, "this comment is never closed, expected \"*/\"");
            at_ = end + 2;
        } else {
            return fail(start, "unexpected character, found \"/\"");
        }
        blank(start, at_);
    }

    void number() {
        const std::size_t start = at_;
        while (at_ < text_.size() && isNumberPart(text_[at_])) ++at_;
        const std::string_view token = text_.substr(start, at_ - start);
        if (!isNumber(token)) fail(start, fmt::format("expected a number, found {}", inQuotes(token)));
    }

    void word() {
        const std::size_t start = at_;
        while (at_ < text_.size() && (isLetter(text_[at_]) || isDigit(text_[at_]))) ++at_;
        const std::string_view token = text_.substr(start, at_ - start);
        static constexpr std::array<std::string_view, 3> words{"true", "false", "null"};
        for (const std::string_view known : words) {
            if (token == known) return;
        }
        fail(start, fmt::format("expected a value or a string in double quotes, found the word {}{}",
                                inQuotes(token), suggestion(token, words)));
    }

    void string() {
        lastString_ = at_;
        ++at_;
        while (!scan_.fault) {
            const char c = peek();
            if (at_ >= text_.size() || c == '\n' || c == '\r') {
                return fail(lastString_, "this string has no closing double quote on its line");
            }
            if (c == '"') break;
            if (c == '\\') {
                escape();
            } else if (static_cast<unsigned char>(c) < 0x20) {
                fail(at_, fmt::format("a control character in a string, expected the escape \\u{:04x}",
                                      static_cast<unsigned char>(c)));
            } else {
                ++at_;
            }
        }
        ++at_;
    }

    void escape() {
        static constexpr std::string_view simple = "\"\\/bfnrt";
        if (peek(1) != 'u') {
            if (peek(1) == '\0' || simple.find(peek(1)) == none) {
                return fail(
                    at_, "unknown escape in a string, expected \\\" \\\\ \\/ \\b \\f \\n \\r \\t or \\uXXXX");
            }
            at_ += 2;
            return;
        }
        const std::optional<unsigned> unit = codeUnit();
        if (!unit) return fail(at_, "expected four hexadecimal digits after \\u");
        const std::size_t start = at_;
        at_ += 6;
        if (*unit < 0xD800 || *unit > 0xDFFF) return;
        const std::optional<unsigned> low = *unit < 0xDC00 ? codeUnit() : std::nullopt;
        if (!low || *low < 0xDC00 || *low > 0xDFFF)
            return fail(start, "half of a surrogate pair in a string");
        at_ += 6;
    }

    /// The value of the escape \uXXXX that stands here, if one does.
    std::optional<unsigned> codeUnit() const {
        if (peek() != '\\' || peek(1) != 'u') return std::nullopt;
        unsigned value = 0;
        for (std::size_t i = 2; i < 6; ++i) {
            const char c = peek(i);
            const char lower = c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c;
            if (isDigit(lower)) {
                value = value * 16 + static_cast<unsigned>(lower - '0');
            } else if (lower >= 'a' && lower <= 'f') {
                value = value * 16 + static_cast<unsigned>(lower - 'a') + 10;
            } else {
                return std::nullopt;
            }
        }
        return value;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int depth_ = 0;
    std::size_t lastString_ = none;
    std::size_t keyOfNextValue_ = none;
    Scan scan_;
};

}  // namespace

std::size_t byteOrderMarkLength(std::string_view text) {
    return text.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0;
}

Scan scan(std::string_view text) {
    const std::size_t valid = validUtf8Length(text);
    if (valid < text.size()) {
        const auto byte = static_cast<unsigned char>(text[valid]);
        return {{}, TextFault{valid, fmt::format("expected UTF-8 text, found the byte 0x{:02X}", byte)}, {}};
    }
    return Scanner(text).run();
}

std::string describeTextAt(std::string_view text, std::size_t offset) {
    if (offset >= text.size()) return "the end of the text";
    const std::string_view rest = text.substr(offset);
    if (rest[0] == '"') {
        const std::size_t end = rest.find_first_of("\"\r\n", 1);
        return fmt::format("the string {}", inQuotes(rest.substr(1, end == none ? none : end - 1)));
    }
    std::size_t length = 1;
    if (isNumberStart(rest[0]) || isLetter(rest[0])) {
        while (length < rest.size() && isNumberPart(rest[length])) ++length;
        return fmt::format("{}{}", isLetter(rest[0]) ? "the word " : "", inQuotes(rest.substr(0, length)));
    }
    while (length < rest.size() && (static_cast<unsigned char>(rest[length]) & 0xC0U) == 0x80U) ++length;
    return inQuotes(rest.substr(0, length));
}

}  // namespace nephrite::json
