// The expression language of graphs and manifests: `when`, `skipWhen`, `neededWhen`, sizes, layer and element
// counts.
//
// Numbers, booleans, || && ! == != < <= > >= + - * /, parentheses, and the names params.X, params.X[i],
// graph.PARAMETER, scene.FACT and inputs.PORT.neutral. An expression is compiled once to a flat program for a
// stack machine and can then be evaluated any number of times; nothing recurses over its length.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "text/diagnostics.h"

namespace nephrite::graph {

/// A name an expression uses.
struct ExpressionName {
    enum class Space : std::uint8_t { Parameter, GraphParameter, SceneFact, InputNeutral };
    Space space;
    std::string name;
    std::optional<std::uint32_t> element;  ///< params.X[i]
    SourceLocation where;

    friend bool operator==(const ExpressionName&, const ExpressionName&) = default;
};

/// A compiled expression. Booleans are 0 and 1.
class Expression {
  public:
    struct Instruction {
        enum class Code : std::uint8_t {
            Constant,
            Name,
            Or,
            And,
            Not,
            Equal,
            NotEqual,
            Less,
            LessEqual,
            Greater,
            GreaterEqual,
            Add,
            Subtract,
            Multiply,
            Divide,
            Negate
        };
        Code code;
        std::uint32_t name = 0;  ///< index into names()
        double constant = 0;
    };

    static Expression constant(double value, SourceLocation where = {});
    /// `$NAME` in a graph stands for graph.NAME.
    static Expression graphParameter(std::string name, SourceLocation where);

    /// Compiles `text`, which starts at `where` in its file; adds syntax faults (column of the fault) to
    /// `diagnostics`.
    static std::optional<Expression> compile(const std::string& text, const SourceLocation& where,
                                             Diagnostics& diagnostics);

    const std::vector<ExpressionName>& names() const { return names_; }
    const std::string& text() const { return text_; }
    const SourceLocation& where() const { return where_; }
    /// Its value if it uses no name: the same at every evaluation.
    std::optional<double> literal() const;
    const std::vector<Instruction>& program() const { return program_; }

    /// The value; `lookup` gives each name its number. Division by zero gives an infinity as IEEE 754 does.
    double evaluate(const std::function<double(const ExpressionName&)>& lookup) const;

  private:
    std::string text_;
    SourceLocation where_;
    std::vector<ExpressionName> names_;
    std::vector<Instruction> program_;
};

}  // namespace nephrite::graph
