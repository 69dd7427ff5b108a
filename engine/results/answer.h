#pragma once
// The results of a run in words: its answer and the assumptions of the answer.

#include <string>
#include <string_view>

#include "results/results.h"

namespace flyrock {

struct Plan;

/// The run in a few sentences: what barriers, gates and trees do, how far rocks went, the clearances and
/// areas of the scenario, and which share of the rocks is censored. In a sweep, the least and the greatest
/// number with their points.
std::string answer(const Plan& plan, const Results& results);

/// "The launch of `blocks` gives no elevation, 45 deg is assumed." for all groups for which this holds;
/// otherwise empty.
std::string assumed_elevations(const Plan& plan);
/// Of each table of rocks: how many there are, and by which factors their lengths are scaled; empty without
/// one.
std::string scales_of_tables(const Scenario& scenario);
/// What is assumed of trees, and that their law is unverified; empty without a forest.
std::string assumed_trees(const Plan& plan);

/// "terrain: 227,000 cells of 5 m, 412 to 1,180 m, EPSG:2056", for each ground that comes from a file; empty
/// without one.
std::string surveyed_ground(const Plan& plan);

/// The assumptions of the answer: dimension, method, elevations, what is left out.
std::string assumptions(const Plan& plan);

/// The name of a stop reason in texts. With the method ballistic nothing comes to rest.
std::string_view ended(StopReason reason, const Scenario& scenario);

/// "182 m", ">= 182 m", "-" if there is no value. Three significant digits.
std::string display(const Bounded& number, std::string_view unit);

}  // namespace flyrock
