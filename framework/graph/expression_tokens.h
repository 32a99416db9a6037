// The words of an expression, read one at a time from left to right.
#pragma once

#include <optional>
#include <string_view>

#include "graph/expression.h"

namespace nephrite::graph {

/// An infix or prefix operator: how tightly it binds (more is tighter) and what it does.
struct Operator {
    std::string_view text;
    int precedence = 0;
    Expression::Instruction::Code code{};
};
inline constexpr int prefixPrecedence = 7;  ///< of ! and -, tighter than every infix operator

class ExpressionTokens {
  public:
    /// `where` is the place of the text's first byte in its file. Both must outlive this.
    ExpressionTokens(std::string_view text, const SourceLocation& where, Diagnostics& diagnostics)
        : text_(text), where_(where), diagnostics_(diagnostics) {}

    void skipSpaces();
    bool atEnd() const { return at_ >= text_.size(); }
    std::size_t offset() const { return at_; }
    /// Consumes the character if it stands here.
    bool take(char character);
    /// The infix operator that stands here, consumed, or nothing.
    std::optional<Operator> takeInfix();
    /// The prefix operator that stands here, consumed, or nothing.
    std::optional<Operator> takePrefix();

    bool numberStartsHere() const;
    /// The number or the name that stands here, consumed; a fault and nothing if it is malformed.
    std::optional<double> takeNumber();
    /// `true` or `false`, consumed, or nothing.
    std::optional<double> takeBoolean();
    std::optional<ExpressionName> takeName();

    void fault(std::size_t offset, std::string message);
    /// What stands here, for "found ...".
    std::string found() const;

  private:
    SourceLocation placeOf(std::size_t offset) const;
    std::string_view takeIdentifier();
    std::optional<std::uint32_t> takeElement();

    std::string_view text_;
    const SourceLocation& where_;
    Diagnostics& diagnostics_;
    std::size_t at_ = 0;
};

}  // namespace nephrite::graph
