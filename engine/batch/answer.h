#pragma once
// What a run says in words: its answer and what it rests on.

#include <string>
#include <string_view>

#include "batch/results.h"

namespace flyrock {

/// The run in a few sentences: how far rocks went, the clearances that were asked for, and which share of the rocks is
/// censored. Over a sweep each number is the range over its points.
std::string answer(const Plan& plan, const Results& results);

/// What the answer takes for granted: dimension, method, what is left out.
std::string assumptions(const Plan& plan);

/// "182 m", ">= 182 m", "-" where there is no value: four significant digits.
std::string display(const Bounded& number, std::string_view unit);

}  // namespace flyrock
