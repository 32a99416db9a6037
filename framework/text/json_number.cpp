// Numbers as short as they can be written, see json_edit.h.
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "text/json_edit.h"

namespace nephrite::json {
namespace {

/// Scientific notation without what an exponent does not need: 1e5 of 1e+05.
std::string tidied(std::string text) {
    std::size_t at = text.find('e');
    if (at == std::string::npos) return text;
    ++at;
    if (text[at] == '+') text.erase(at, 1);
    if (text[at] == '-') ++at;
    while (at + 1 < text.size() && text[at] == '0') text.erase(at, 1);
    return text;
}

template<class Number, class... Format>
std::string digitsOf(Number value, Format... format) {
    std::array<char, 40> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, format...).ptr;
    return tidied({digits.data(), end});
}

template<class Number>
std::string shortest(Number value) {
    if (!std::isfinite(value)) throw std::invalid_argument("JSON has no number that is not finite");
    constexpr std::size_t easilyRead = 7;  // 1000 is read more easily than 1e3
    std::string text = digitsOf(value);
    if (text.size() <= easilyRead) return text;
    std::string scientific = digitsOf(value, std::chars_format::scientific);
    return scientific.size() < text.size() ? scientific : text;
}

double read(const std::string& text) {
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

}  // namespace

std::string shortestNumber(double value) {
    return shortest(value);
}

std::string shortestNumber(float value) {
    std::string text = shortest(value);
    // Readers round to a double first, which may bring the number to the wrong side of halfway.
    if (static_cast<float>(read(text)) == value) return text;
    return shortest(static_cast<double>(value));
}

}  // namespace nephrite::json
