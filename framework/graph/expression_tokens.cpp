// See expression_tokens.h.
#include "graph/expression_tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace nephrite::graph {
namespace {

using Code = Expression::Instruction::Code;
using Space = ExpressionName::Space;

/// Longer operators before those they start with.
constexpr std::array<Operator, 12> infixOperators{{{"||", 1, Code::Or},
                                                   {"&&", 2, Code::And},
                                                   {"==", 3, Code::Equal},
                                                   {"!=", 3, Code::NotEqual},
                                                   {"<=", 4, Code::LessEqual},
                                                   {">=", 4, Code::GreaterEqual},
                                                   {"<", 4, Code::Less},
                                                   {">", 4, Code::Greater},
                                                   {"+", 5, Code::Add},
                                                   {"-", 5, Code::Subtract},
                                                   {"*", 6, Code::Multiply},
                                                   {"/", 6, Code::Divide}}};

constexpr std::array<std::string_view, 6> wordsThatStart{"params", "graph", "scene",
                                                         "inputs", "true",  "false"};

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}
bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

std::optional<Space> spaceNamed(std::string_view word) {
    if (word == "params") return Space::Parameter;
    if (word == "graph") return Space::GraphParameter;
    if (word == "scene") return Space::SceneFact;
    if (word == "inputs") return Space::InputNeutral;
    return std::nullopt;
}

}  // namespace

void ExpressionTokens::skipSpaces() {
    while (!atEnd() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n' || text_[at_] == '\r'))
        ++at_;
}

bool ExpressionTokens::take(char character) {
    if (atEnd() || text_[at_] != character) return false;
    ++at_;
    return true;
}

std::optional<Operator> ExpressionTokens::takeInfix() {
    for (const Operator& infix : infixOperators) {
        if (text_.substr(at_, infix.text.size()) != infix.text) continue;
        at_ += infix.text.size();
        return infix;
    }
    return std::nullopt;
}

std::optional<Operator> ExpressionTokens::takePrefix() {
    if (take('!')) return Operator{"!", prefixPrecedence, Code::Not};
    if (take('-')) return Operator{"-", prefixPrecedence, Code::Negate};
    return std::nullopt;
}

bool ExpressionTokens::numberStartsHere() const {
    if (atEnd()) return false;
    const bool point = text_[at_] == '.' && at_ + 1 < text_.size() && isDigit(text_[at_ + 1]);
    return isDigit(text_[at_]) || point;
}

std::optional<double> ExpressionTokens::takeNumber() {
    double value = 0;
    const char* start = text_.data() + at_;
    const auto [end, error] = std::from_chars(start, text_.data() + text_.size(), value);
    const std::string_view token(start, static_cast<std::size_t>(end - start));
    const bool wordFollows = end != text_.data() + text_.size() && (isLetter(*end) || *end == '.');
    if (error != std::errc() || wordFollows) {
        const std::string_view why = wordFollows ? "expected an operator after" : "out of a double's range:";
        fault(at_, fmt::format("{} the number {}", why, token));
        return std::nullopt;
    }
    at_ += token.size();
    return value;
}

std::string_view ExpressionTokens::takeIdentifier() {
    const std::size_t start = at_;
    while (!atEnd() && (isLetter(text_[at_]) || (at_ > start && isDigit(text_[at_])))) ++at_;
    return text_.substr(start, at_ - start);
}

std::optional<double> ExpressionTokens::takeBoolean() {
    const std::size_t start = at_;
    const std::string_view word = takeIdentifier();
    if (word == "true") return 1.0;
    if (word == "false") return 0.0;
    at_ = start;
    return std::nullopt;
}

std::optional<ExpressionName> ExpressionTokens::takeName() {
    const std::size_t start = at_;
    const bool dollar = take('$');
    const std::string_view word = dollar ? "graph" : takeIdentifier();
    const std::optional<Space> space = spaceNamed(word);
    if (!space) {
        if (word.empty()) at_ = start;
        fault(start,
              fmt::format(
                  "expected a number or one of params.X, graph.X, scene.X and inputs.X.neutral, found {}{}",
                  word.empty() ? found() : inQuotes(word), suggestion(word, wordsThatStart)));
        return std::nullopt;
    }
    const bool pointed = dollar || take('.');
    const std::string_view name = pointed ? takeIdentifier() : std::string_view();
    if (name.empty()) {
        fault(at_, fmt::format("expected {}a name after {}, found {}", pointed ? "" : "\".\" and ",
                               dollar ? "\"$\"" : inQuotes(word), found()));
        return std::nullopt;
    }
    ExpressionName result{*space, std::string(name), std::nullopt, placeOf(start)};
    if (*space == Space::InputNeutral) {
        const std::size_t after = at_;
        if (!take('.') || takeIdentifier() != "neutral") {
            at_ = after;
            fault(after, fmt::format("expected \".neutral\" after inputs.{}, found {}", name, found()));
            return std::nullopt;
        }
    }
    if (*space == Space::Parameter && take('[')) {
        result.element = takeElement();
        if (!result.element) return std::nullopt;
    }
    return result;
}

std::optional<std::uint32_t> ExpressionTokens::takeElement() {
    std::uint32_t element = 0;
    skipSpaces();
    const char* start = text_.data() + at_;
    const auto [end, error] = std::from_chars(start, text_.data() + text_.size(), element);
    if (error != std::errc()) {
        fault(at_, fmt::format("expected an element's number, found {}", found()));
        return std::nullopt;
    }
    at_ += static_cast<std::size_t>(end - start);
    skipSpaces();
    if (!take(']')) {
        fault(at_, fmt::format("expected \"]\" after the element's number, found {}", found()));
        return std::nullopt;
    }
    return element;
}

SourceLocation ExpressionTokens::placeOf(std::size_t offset) const {
    SourceLocation place = where_;
    if (place.line != 0) place.column += static_cast<std::uint32_t>(offset);
    return place;
}

void ExpressionTokens::fault(std::size_t offset, std::string message) {
    diagnostics_.error(placeOf(offset), std::move(message));
}

std::string ExpressionTokens::found() const {
    if (atEnd()) return "the end of the expression";
    std::size_t length = 1;
    const auto follows = [&](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U ||
               ((isLetter(text_[at_]) || isDigit(text_[at_])) && (isLetter(c) || isDigit(c)));
    };
    while (at_ + length < text_.size() && follows(text_[at_ + length])) ++length;
    return inQuotes(text_.substr(at_, length));
}

}  // namespace nephrite::graph
