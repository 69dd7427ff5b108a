#pragma once
// Roots of polynomials of low degree in an interval.

#include <optional>
#include <span>

namespace flyrock {

/// p(t) = c[0] + c[1] t + ... + c[n] t^n.
double evaluate(std::span<const double> c, double t);

/// The first t in [low, high] at which p falls through zero: p(t) <= 0 and p falls there. If p(low) <= 0 and
/// p falls at low, the answer is low. If p(low) <= 0 and p rises, the search continues to the next fall.
/// Degree <= 10. The roots are bracketed between the roots of the derivative, which are found in the same
/// way, so that none is missed. The answer is the end of the last bracket at which p >= 0.
std::optional<double> first_fall(std::span<const double> c, double low, double high);

/// The first t in [low, high] at which p <= 0 and p falls, for a gap that may begin below zero. The same as
/// first_fall, except if p(low) <= 0 and p rises but turns before it reaches zero: then the answer is that
/// turn.
std::optional<double> first_approach(std::span<const double> c, double low, double high);

}  // namespace flyrock
