// See utf8.h.
#include "text/utf8.h"

#include <array>

namespace nephrite {
namespace {

/// A row of table 3-7: first bytes from..to take `following` more bytes, the first of them in low..high.
struct Row {
    unsigned char from, to;
    std::size_t following;
    unsigned char low, high;
};
constexpr std::array<Row, 9> table{{{0x00, 0x7F, 0, 0, 0},
                                    {0xC2, 0xDF, 1, 0x80, 0xBF},
                                    {0xE0, 0xE0, 2, 0xA0, 0xBF},
                                    {0xE1, 0xEC, 2, 0x80, 0xBF},
                                    {0xED, 0xED, 2, 0x80, 0x9F},
                                    {0xEE, 0xEF, 2, 0x80, 0xBF},
                                    {0xF0, 0xF0, 3, 0x90, 0xBF},
                                    {0xF1, 0xF3, 3, 0x80, 0xBF},
                                    {0xF4, 0xF4, 3, 0x80, 0x8F}}};

/// Bytes of the character that starts the text, or 0 if it is malformed.
std::size_t characterLength(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    for (const Row& row : table) {
        if (byte(0) < row.from || byte(0) > row.to) continue;
        if (text.size() <= row.following) return 0;
        for (std::size_t i = 1; i <= row.following; ++i) {
            const bool first = i == 1;
            if (byte(i) < (first ? row.low : 0x80) || byte(i) > (first ? row.high : 0xBF)) return 0;
        }
        return row.following + 1;
    }
    return 0;
}

}  // namespace

std::size_t validUtf8Length(std::string_view text) {
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t length = characterLength(text.substr(at));
        if (length == 0) break;
        at += length;
    }
    return at;
}

}  // namespace nephrite
