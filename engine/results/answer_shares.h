#pragma once
// The shares of an answer in words: how many rocks are censored and where, what barriers held and what not.

#include <string>

#include "results/results.h"

namespace flyrock {

/// "12.3 %"
std::string percent(double share);

/// "12.3 % (95 % interval 10.1 to 14.8 %)", ">= 0 % (95 % interval up to 0.369 %)", "-" of none of 0.
std::string display(const Share& share);

/// "on haul_floor (part floor), x from 120 to 180 m": where censored rocks were, as the end of a sentence.
std::string place_text(const Scenario& scenario, const PointResult& point, const CensoredPlace& place);
/// The material that a part of the terrain shows; empty where it has none (method ballistic).
std::string material_of(const Scenario& scenario, const PointResult& point, int part);

/// " No rock is censored (95 % interval up to 0.369 %)."; else which share, why and where.
std::string censored_answer(const Plan& plan, const Results& results);

/// " Barrier fence: 62 % of the rocks reach it (...); it catches 50 % (...), ..."; empty where there is none.
std::string barriers_answer(const Plan& plan, const Results& results);

}  // namespace flyrock
