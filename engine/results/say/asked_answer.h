#pragma once
// What a run says of clearances and exposures in words, beside the table of questions (questions.h).

#include <string>

namespace flyrock {

struct Plan;
struct Results;

/// In a sweep: each clearance and exposure from the point with the least to that with the greatest number.
std::string asked_over_points(const Plan& plan, const Results& results);

/// What the table of questions has no room for, in a run without a sweep: the direction in which an area
/// reaches farthest, areas of least size, known throws, how many rocks a blast has, and how often a rock
/// lands on a road.
std::string beside_questions(const Plan& plan, const Results& results);

}  // namespace flyrock
