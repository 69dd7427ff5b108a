#pragma once
// What a run says in words: its answer and what it rests on.

#include <string>
#include <string_view>

#include "results/results.h"

namespace flyrock {

/// The run in a few sentences: how far rocks went, the clearances that were asked for, and which share of the
/// rocks is censored. Over a sweep each number is the range over its points.
std::string answer(const Plan& plan, const Results& results);

/// "The launch of `blocks` gives no elevation, 45 deg is assumed." for all groups of which that holds; else
/// an empty text.
std::string assumed_elevations(const Scenario& scenario);

/// What the answer takes for granted: dimension, method, elevations, what is left out.
std::string assumptions(const Plan& plan);

/// What a runout is called: in the method ballistic, in which a path ends at its first landing, the distance
/// of that. Keys of files and measures keep their names.
std::string_view runout_name(const Scenario& scenario);
/// What a reason to stop is called: in the method ballistic nothing comes to rest.
std::string_view ended(StopReason reason, const Scenario& scenario);

/// "182 m", ">= 182 m", "-" where there is no value: four significant digits.
std::string display(const Bounded& number, std::string_view unit);

}  // namespace flyrock
