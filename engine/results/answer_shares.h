#pragma once
// The shares of an answer in words: how many rocks are censored and where, what barriers held and what they
// did not hold.

#include <string>

#include "results/results.h"

namespace flyrock {

/// "12.3 %"
std::string percent(double share);

/// "12.3 % (95 % interval 10.1 to 14.8 %)", ">= 0 % (95 % interval up to 0.369 %)", "-" for 0 of 0.
std::string display(const Share& share);

/// Where censored rocks were, as the end of a sentence: "on haul_floor (part floor), x from 120 to 180 m".
std::string place_text(const Scenario& scenario, const PointResult& point, const CensoredPlace& place);
/// The material of a part of the terrain; empty if it has none (method ballistic).
std::string material_of(const Scenario& scenario, const PointResult& point, int part);

/// " No rock is censored (95 % interval up to 0.369 %).", or which share is censored, why and where.
std::string censored_answer(const Plan& plan, const Results& results);

/// What the barriers do, which an answer says first: "Barrier fence catches 50 % (...) of the rocks; 3 %
/// (...) go over the top, ... "; of `bodies`, how many. Ends with a space; empty if there are no barriers.
/// "Trees stop 21 % (95 % interval ...) of the rocks; 63 % hit at least one. "; empty without a forest. In a
/// sweep, the least to the greatest share.
std::string trees_answer(const Plan& plan, const Results& results);
std::string barriers_answer(const Plan& plan, const Results& results);

}  // namespace flyrock
