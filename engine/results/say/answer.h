#pragma once
// The results of a run in words: its answer and the assumptions of the answer.

#include <string>
#include <string_view>

#include "results/results.h"
#include "results/say/questions.h"

namespace flyrock {

struct Plan;

/// The run in a few sentences.
struct AnswerTexts {
  /// What the scenario asks, in one sentence: who is hit and how far a blast throws; of a sweep its best
  /// point or the smallest barriers that hold. Empty if it asks nothing of this kind.
  std::string first;
  std::vector<Question> questions;  ///< the table after it, of a run without a sweep
  std::string asked;                ///< barriers, gates and trees, and what stands beside the table
  std::string distances;            ///< how far rocks went
  std::string remarks;              ///< the share of censored rocks, measurements, weights, faults

  std::string rest() const;  ///< all after `first`
  /// The same without `distances`, for the terminal, which has a table of them.
  std::string beside_table() const;
};
AnswerTexts answer_texts(const Plan& plan, const Results& results);
/// All of them in one text. In a sweep, numbers are the least and the greatest, with their points.
std::string answer(const Plan& plan, const Results& results);

/// "The launch of `blocks` gives no elevation, 45 deg is assumed." for all groups for which this holds;
/// otherwise empty.
std::string assumed_elevations(const Plan& plan);
/// How many rocks each table has, and by which factors their lengths are scaled; empty without
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
