// Text -> program for the stack machine, by Dijkstra's shunting-yard algorithm (1961): operators wait on a
// stack until one that binds less tightly arrives, so nothing recurses over nested parentheses.
#include <fmt/format.h>

#include "graph/expression_tokens.h"

namespace nephrite::graph {
namespace {

using Instruction = Expression::Instruction;

constexpr std::size_t longestExpression = 4096;
constexpr int deepestParentheses = 200;

class Compiler {
  public:
    Compiler(std::string_view text, const SourceLocation& where, Diagnostics& diagnostics)
        : tokens_(text, where, diagnostics) {}

    /// False, with one fault added, if the text is no expression.
    bool run() {
        while (true) {
            if (!operand()) return false;
            if (!closeParentheses()) return false;
            if (tokens_.atEnd()) return finish();
            const std::size_t offset = tokens_.offset();
            const std::optional<Operator> infix = tokens_.takeInfix();
            if (!infix) {
                tokens_.fault(offset, fmt::format("expected an operator, found {}", tokens_.found()));
                return false;
            }
            release(infix->precedence);
            waiting_.push_back({*infix, offset});
        }
    }

    std::vector<ExpressionName> names;
    std::vector<Instruction> program;

  private:
    /// An operator or, with precedence 0, an open parenthesis; and where it stands.
    struct Waiting {
        Operator what;
        std::size_t offset;
    };

    /// Prefix operators and open parentheses, then a number, a boolean or a name.
    bool operand() {
        while (true) {
            tokens_.skipSpaces();
            const std::size_t offset = tokens_.offset();
            if (const std::optional<Operator> prefix = tokens_.takePrefix()) {
                waiting_.push_back({*prefix, offset});
            } else if (tokens_.take('(')) {
                waiting_.push_back({Operator{"(", 0, {}}, offset});
                if (++openParentheses_ > deepestParentheses) {
                    tokens_.fault(offset, fmt::format("parentheses are nested deeper than {} levels",
                                                      deepestParentheses));
                    return false;
                }
            } else {
                return numberOrName();
            }
        }
    }

    bool numberOrName() {
        if (tokens_.atEnd()) {
            tokens_.fault(tokens_.offset(),
                          "expected a number, a name or \"(\", found the end of the expression");
            return false;
        }
        const bool isNumber = tokens_.numberStartsHere();
        const std::optional<double> constant = isNumber ? tokens_.takeNumber() : tokens_.takeBoolean();
        if (constant) {
            program.push_back({Instruction::Code::Constant, 0, *constant});
            return true;
        }
        if (isNumber) return false;
        std::optional<ExpressionName> name = tokens_.takeName();
        if (!name) return false;
        program.push_back({Instruction::Code::Name, static_cast<std::uint32_t>(names.size()), 0});
        names.push_back(std::move(*name));
        return true;
    }

    bool closeParentheses() {
        tokens_.skipSpaces();
        std::size_t offset = tokens_.offset();
        while (tokens_.take(')')) {
            release(1);
            if (waiting_.empty()) {
                tokens_.fault(offset, "this \")\" closes nothing");
                return false;
            }
            waiting_.pop_back();
            --openParentheses_;
            tokens_.skipSpaces();
            offset = tokens_.offset();
        }
        return true;
    }

    /// Puts out the operators, back to the last open parenthesis, that bind at least as tightly.
    void release(int precedence) {
        while (!waiting_.empty() && waiting_.back().what.precedence >= precedence) {
            program.push_back({waiting_.back().what.code, 0, 0});
            waiting_.pop_back();
        }
    }

    bool finish() {
        release(1);
        if (waiting_.empty()) return true;
        tokens_.fault(waiting_.back().offset, "this \"(\" is never closed");
        return false;
    }

    ExpressionTokens tokens_;
    std::vector<Waiting> waiting_;
    int openParentheses_ = 0;
};

}  // namespace

std::optional<Expression> Expression::compile(const std::string& text, const SourceLocation& where,
                                              Diagnostics& diagnostics) {
    if (text.size() > longestExpression) {
        diagnostics.error(where, fmt::format("an expression has at most {} characters, found {}",
                                             longestExpression, text.size()));
        return std::nullopt;
    }
    Compiler compiler(text, where, diagnostics);
    if (!compiler.run()) return std::nullopt;
    Expression expression;
    expression.text_ = text;
    expression.where_ = where;
    expression.names_ = std::move(compiler.names);
    expression.program_ = std::move(compiler.program);
    return expression;
}

}  // namespace nephrite::graph
