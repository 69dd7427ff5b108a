#pragma once
// What a permit asks of a sweep point: how far a blast throws, and whom it hits. Each clearance and each
// exposure of the scenario is a question: a row of a table, and a clause of the first sentence of the answer.
// The terminal, the page and its print take their texts from here.

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "results/results.h"

namespace flyrock {

struct Question {
  std::string asks;       ///< "house: hit by a rock of 20 J or more"
  std::string per_blast;  ///< "0.527 %, one in 190"
  std::string interval;  ///< of `per_blast`, or of the distance in `asks`: "0.319 to 0.856 %", "540 to 650 m"
  std::string per_year;  ///< "41 % of 100 blasts"; empty without a number of blasts
  std::string limit;     ///< "400 m", "1 % a year"; empty without a limit
  std::string verdict;   ///< "held", "not held", "not shown"; empty without a limit
  std::string clause;    ///< "one blast in 190 hits house"; empty where the row before says it
};

/// The heads of the columns from `asks` to `verdict`.
inline constexpr std::array<std::string_view, 6> question_heads = {"question", "a blast", "95 % interval",
                                                                   "a year",   "limit",   "held?"};

/// In the order of the scenario; none where too many rocks are lost. A verdict is "held" if the whole
/// interval keeps the limit, "not held" if all of it exceeds it, else "not shown": more trials may tell.
std::vector<Question> questions(const Scenario& scenario, const PointResult& point);

/// "One blast in 20 throws a rock beyond 593 m; one in 190 hits house; one in 2090 hits a vehicle on road."
/// Empty without questions.
std::string first_sentence(std::span<const Question> questions);

}  // namespace flyrock
