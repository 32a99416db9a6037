// The incomplete gamma and beta functions behind chi-squared and Student's distribution, and numeric
// integration. Formulas: Abramowitz and Stegun, "Handbook of Mathematical Functions" (1964), 6.5 and 26.5;
// continued fractions by Lentz's method (1976).
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

namespace nephrite::statistics {

/// Value of the continued fraction b_0 + a_1/(b_1 + a_2/(b_2 + ...)), where `term(i)` gives a_i and b_i for i
/// >= 1.
template<class Term>
double continuedFraction(double start, Term term) {
    constexpr double tiny = 1e-300;
    constexpr int most = 100000;
    double value = start == 0 ? tiny : start;
    double numerators = value;
    double denominators = 0;
    for (int i = 1; i < most; ++i) {
        const auto [a, b] = term(i);
        denominators = b + a * denominators;
        numerators = b + a / numerators;
        if (denominators == 0) denominators = tiny;
        if (numerators == 0) numerators = tiny;
        denominators = 1 / denominators;
        const double factor = numerators * denominators;
        value *= factor;
        if (std::abs(factor - 1) < std::numeric_limits<double>::epsilon()) break;
    }
    return value;
}

struct FractionTerm {
    double a;
    double b;
};

/// Q(a, x): the upper incomplete gamma function over the whole one, for a > 0 and x >= 0.
inline double upperGamma(double a, double x) {
    if (x <= 0) return 1;
    const double scale = std::exp(a * std::log(x) - x - std::lgamma(a));
    if (x > a + 1) {
        return scale / continuedFraction(x + 1 - a, [&](int i) {
                   return FractionTerm{i * (a - i), x + 2 * i + 1 - a};
               });
    }
    double term = 1 / a;
    double sum = term;
    for (int i = 1; term > sum * std::numeric_limits<double>::epsilon(); ++i) {
        term *= x / (a + i);
        sum += term;
    }
    return 1 - scale * sum;
}

/// I_x(a, b): the incomplete beta function over the whole one, for a, b > 0 and x from 0 to 1.
inline double incompleteBeta(double a, double b, double x) {
    if (x <= 0) return 0;
    if (x >= 1) return 1;
    const bool swapped = x > (a + 1) / (a + b + 2);  // where the fraction converges faster for the complement
    if (swapped) {
        std::swap(a, b);
        x = 1 - x;
    }
    const double scale = std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) +
                                  b * std::log1p(-x)) /
                         a;
    const double value = scale / continuedFraction(1, [&](int i) {
                             const int m = i / 2;
                             const double a2m = a + 2 * m;
                             if (i % 2 == 0) return FractionTerm{m * (b - m) * x / ((a2m - 1) * a2m), 1};
                             return FractionTerm{-(a + m) * (a + b + m) * x / (a2m * (a2m + 1)), 1};
                         });
    return swapped ? 1 - value : value;
}

/// Integral by the double exponential rule (Takahasi and Mori 1974), which bears peaks and poles at the ends.
/// The step is halved until two results agree to 1e-11.
template<class Function>
double integrate(double low, double high, Function&& function) {
    constexpr double reach = 3.2;  // beyond it the nodes meet the ends in double precision
    const double half = (high - low) / 2;
    const auto atNode = [&](double t) {
        const double u = std::numbers::pi / 2 * std::sinh(t);
        const double fromEnd = half * std::exp(-std::abs(u)) / std::cosh(u);  // distance to the nearer end
        const double x = t < 0 ? low + fromEnd : high - fromEnd;
        return half * std::numbers::pi / 2 * std::cosh(t) / (std::cosh(u) * std::cosh(u)) * function(x);
    };
    double step = 0.5;
    double sum = atNode(0);
    for (double t = step; t < reach; t += step) sum += atNode(t) + atNode(-t);
    double result = sum * step;
    for (int halvings = 0; halvings < 9; ++halvings) {
        for (double t = step / 2; t < reach; t += step) sum += atNode(t) + atNode(-t);
        step /= 2;
        const double previous = result;
        result = sum * step;
        if (halvings > 1 && std::abs(result - previous) <= 1e-11 * std::abs(result)) break;
    }
    return result;
}

}  // namespace nephrite::statistics
