// See base64.h.
#include "text/base64.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace nephrite {

std::string base64(std::span<const std::byte> bytes) {
    static constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t start = 0; start < bytes.size(); start += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - start);
        std::uint32_t bits = 0;
        for (std::size_t i = 0; i < 3; ++i)
            bits = bits << 8U | (i < count ? std::to_integer<std::uint32_t>(bytes[start + i]) : 0U);
        for (std::size_t i = 0; i < 4; ++i) text += i <= count ? digits[bits >> (18U - 6U * i) & 63U] : '=';
    }
    return text;
}

}  // namespace nephrite
