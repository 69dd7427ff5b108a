#pragma once
// The shares of an answer in words: how many rocks are censored and where, what barriers held and what they
// did not hold.

#include <string>

#include "results/results.h"

namespace flyrock {

struct Plan;

/// Where censored rocks were, as the end of a sentence: "on haul_floor (part floor), x from 120 to 180 m".
std::string place_text(const Scenario& scenario, const PointResult& point, const CensoredPlace& place);
/// The material of a part of the terrain; empty if it has none (method ballistic).
std::string material_of(const Scenario& scenario, const PointResult& point, int part);

/// " No rock is censored (95 % interval up to 0.369 %).", or which share is censored, why and where.
std::string censored_answer(const Plan& plan, const Results& results);

/// What trees, barriers and gates do, which an answer says first; empty without any. Of several groups each
/// has a sentence, because a share of all rocks depends on how many of each were run. In a sweep, the least
/// to the greatest share with their points. Ends with a space.
std::string trees_answer(const Plan& plan, const Results& results);
std::string barriers_answer(const Plan& plan, const Results& results);
std::string gates_answer(const Plan& plan, const Results& results);

}  // namespace flyrock
