#pragma once
// Roots of polynomials of low degree in an interval.

#include <optional>
#include <span>

namespace flyrock {

/// p(t) = c[0] + c[1] t + ... + c[n] t^n.
double evaluate(std::span<const double> c, double t);

/// The first t in [low, high] at which p falls through zero: p(t) <= 0 with p falling there. Where p(low) <=
/// 0 and p falls at low the answer is low; where p(low) <= 0 and p rises, the next fall is looked for. Degree
/// <= 5. The roots are bracketed between those of the derivative, found in the same way, so that none is
/// missed; the answer is the end of the last bracket on which p >= 0.
std::optional<double> first_fall(std::span<const double> c, double low, double high);

/// The first t in [low, high] at which p <= 0 and p falls, for a gap that may begin below zero. As
/// first_fall; in addition, where p(low) <= 0 and p rises but turns before it reaches zero, the answer is
/// that turn.
std::optional<double> first_approach(std::span<const double> c, double low, double high);

}  // namespace flyrock
