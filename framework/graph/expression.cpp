// Constants and evaluation; expression_compiler.cpp turns text into the program that runs here.
#include "graph/expression.h"

#include <fmt/format.h>

namespace nephrite::graph {
namespace {

using Code = Expression::Instruction::Code;

double truth(bool value) {
    return value ? 1.0 : 0.0;
}

double apply(Code code, double left, double right) {
    switch (code) {
        case Code::Or:
            return truth(left != 0 || right != 0);
        case Code::And:
            return truth(left != 0 && right != 0);
        case Code::Equal:
            return truth(left == right);
        case Code::NotEqual:
            return truth(left != right);
        case Code::Less:
            return truth(left < right);
        case Code::LessEqual:
            return truth(left <= right);
        case Code::Greater:
            return truth(left > right);
        case Code::GreaterEqual:
            return truth(left >= right);
        case Code::Add:
            return left + right;
        case Code::Subtract:
            return left - right;
        case Code::Multiply:
            return left * right;
        case Code::Divide:
            return left / right;
        case Code::Constant:
        case Code::Name:
        case Code::Not:
        case Code::Negate:
            break;
    }
    return 0;
}

}  // namespace

Expression Expression::constant(double value, SourceLocation where) {
    Expression expression;
    expression.text_ = fmt::format("{}", value);
    expression.where_ = std::move(where);
    expression.program_ = {{Code::Constant, 0, value}};
    return expression;
}

Expression Expression::graphParameter(std::string name, SourceLocation where) {
    Expression expression;
    expression.text_ = "$" + name;
    expression.where_ = where;
    expression.names_ = {
        {ExpressionName::Space::GraphParameter, std::move(name), std::nullopt, std::move(where)}};
    expression.program_ = {{Code::Name, 0, 0}};
    return expression;
}

std::optional<double> Expression::literal() const {
    if (!names_.empty()) return std::nullopt;
    return evaluate([](const ExpressionName&) { return 0.0; });
}

double Expression::evaluate(const std::function<double(const ExpressionName&)>& lookup) const {
    if (program_.size() == 1 && program_[0].code == Code::Constant) return program_[0].constant;
    std::vector<double> stack;
    stack.reserve(program_.size());
    for (const Instruction& instruction : program_) {
        if (instruction.code == Code::Constant) {
            stack.push_back(instruction.constant);
        } else if (instruction.code == Code::Name) {
            stack.push_back(lookup(names_[instruction.name]));
        } else if (instruction.code == Code::Not) {
            stack.back() = truth(stack.back() == 0);
        } else if (instruction.code == Code::Negate) {
            stack.back() = -stack.back();
        } else {
            const double right = stack.back();
            stack.pop_back();
            stack.back() = apply(instruction.code, stack.back(), right);
        }
    }
    return stack.back();
}

}  // namespace nephrite::graph
