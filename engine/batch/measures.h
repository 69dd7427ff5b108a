#pragma once
// Measures: the numbers that an expectation can be about, by name.

#include <stdexcept>
#include <string>
#include <vector>

#include "batch/statistics.h"

namespace flyrock {

/// What one point of a sweep left.
struct PointResult {
  std::uint64_t trials = 0;
  TrialRecords records;
  std::vector<GroupSummary> groups;  ///< all rocks first; see summarise()
};

struct Measured {
  double value = 0;
  bool censored = false;  ///< censored rocks fall into it: a lower bound
  std::string fault;      ///< why there is no value: "never came to rest"
};

/// A measure that no scenario of this kind has; the text says what was expected and the nearest name.
struct MeasureError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A measure as its words: body.<name>.final.x, body.<name>.impact[2].vn_after,
/// energy.total.relative_change, solver.max_residual, rocks[.<group>].runout.p95, rocks[.<group>].count.
/// DESIGN section 3 lists them; docs/results.md defines each.
class Measure {
 public:
  /// Throws MeasureError where `scenario` has no such measure.
  Measure(const std::string& name, const Scenario& scenario);

  /// Whether it needs the full number of trials (a statistic of rocks).
  bool of_rocks() const { return kind_ == Kind::statistic || kind_ == Kind::count || kind_ == Kind::censored; }
  Measured value(const PointResult& result) const;

 private:
  enum class Kind { statistic, count, censored, body, energy, solver };

  void read_rocks(const std::vector<std::string>& words, const Scenario& scenario);
  void read_body(const std::vector<std::string>& words, const Scenario& scenario);
  Measured body_value(const BodyHistory& body) const;
  double state_value(const BodyHistory& body) const;

  Kind kind_ = Kind::statistic;
  std::string name_;
  int index_ = 0;       ///< of the group (0: all rocks) or of the body
  int number_ = 0;      ///< of an impact or apex, from 1
  std::string table_;   ///< body: final, max, min, stop_time, contact_time, impact, apex
  std::string field_;   ///< x, vn_before, max_residual
  RockQuantity quantity_ = RockQuantity::runout;
  Statistic statistic_ = Statistic::mean;
};

}  // namespace flyrock
