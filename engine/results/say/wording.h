#pragma once
// Numbers in the sentences of an answer.

#include <cmath>
#include <optional>
#include <string>

#include "results/measured/lost.h"
#include "results/results.h"
#include "scenario/plan.h"

namespace flyrock {

/// Three significant digits, without an exponent: "217", "0.0312", "12300".
std::string three_digits(double value);

/// "12.3 %"
std::string percent(double share);

/// "217 m (95 % interval 210 to 226 m)", ">= 217 m (...)". Without an interval, why: "217 m (too few trials
/// for an interval: about 1200)".
std::string with_interval(const Bounded& number, const Interval& interval, double confidence);

/// "12.3 % (95 % interval 10.1 to 14.8 %)", ">= 0 % (95 % interval up to 0.369 %)", "-" for 0 of 0.
std::string display(const Share& share);

/// "weight 1.2 or less would tell"
std::string telling_text(const BlastBounds& bounds);
/// The share of blasts in which at least one real rock does something: as display(), or, where its bounds do
/// not tell it, "between 3.25 and 96.3 % (95 % interval 2.7 to 97.6 %; weight 1.2 or less would tell)".
std::string display_per_trial(const Shares& shares);

/// "2 m", "coulomb": a value of an axis of a sweep, in the unit that people read.
std::string value_text(const SweepAxis& axis, double value);
/// "materials.rock.friction.mu = 0.2": a point of a sweep by its values, or by the label of its row.
std::string point_text(const Plan& plan, std::size_t point);
/// "mu 0.2": the same within a sentence.
std::string brief_point_text(const Plan& plan, std::size_t point);

/// "110 m (mu 0.2) to 140 m (mu 0.6)": the least and the greatest value that is known, each with its
/// point. One text if they are equal.
template <class ValueAt, class TextAt>
std::string over_points(const Plan& plan, const Results& results, ValueAt value_at, TextAt text_at) {
  std::optional<std::size_t> least, greatest;
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    if (has_lost(plan.points[p], results.points[p]) || std::isnan(value_at(p))) continue;
    if (!least || value_at(p) < value_at(*least)) least = p;
    if (!greatest || value_at(p) > value_at(*greatest)) greatest = p;
  }
  if (!least) return "not known";
  if (value_at(*least) == value_at(*greatest)) return text_at(*least);
  return text_at(*least) + " (" + brief_point_text(plan, *least) + ") to " + text_at(*greatest) + " (" +
         brief_point_text(plan, *greatest) + ")";
}

}  // namespace flyrock
