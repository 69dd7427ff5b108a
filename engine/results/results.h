#pragma once
// Everything that a run found out: what the tables, the report and the terminal show.

#include <string>
#include <utility>
#include <vector>

#include "batch/rows.h"
#include "results/expectations.h"
#include "results/measures.h"

namespace flyrock {

/// A rock that failed, with its reason.
struct Fault {
  int point = 0;
  std::uint64_t trial = 0;
  int rock = 0;
  StopReason reason = StopReason::diverged;
  std::string text;
};

struct Results {
  std::vector<PointResult> points;
  std::vector<Verdict> verdicts;
  std::vector<std::string>
      warnings;  ///< what may make the numbers wrong: of the solver, the reader, the launches
  std::vector<std::string>
      not_asked;              ///< laws that no contact needed; keys that nothing reads are Plan::not_used
  std::vector<Fault> faults;  ///< the first 20
  std::uint64_t fault_count = 0;
  std::string ended_early;  ///< why, or empty where every trial ran

  std::uint64_t rocks() const;
  /// Of the verdicts.
  int count(Judgement judgement) const;
};

/// How the records came about.
struct RunFacts {
  std::vector<std::uint64_t> trials;  ///< that ran, of each point
  bool full = true;                   ///< false where the scenario itself asks for more; see judge()
  std::string ended_early;            ///< why, or empty
  std::vector<std::string> warnings;  ///< of the scenario's reader
};

class PointTally;

/// Finds out what a run left: in a first pass, which may be while it runs, and in further passes over the
/// rows.
class ResultTally {
 public:
  explicit ResultTally(const Plan& plan);
  ~ResultTally();

  /// The chunks of all points in order, with all their rows.
  void see(int point, const TrialRecords& chunk);
  /// The same chunks again. Throws FileError where one cannot be read.
  Results finish(const std::vector<Rows>& rows, const RunFacts& facts);

 private:
  const Plan& plan_;
  Results results_;
  std::vector<PointTally> tallies_;
};

/// All passes at once, over the rows of each point.
Results make_results(const Plan& plan, const std::vector<Rows>& rows, const RunFacts& facts);

/// "material haul_floor: its restitution pfeiffer_bowen was never asked": laws that no contact of any point
/// needed.
std::vector<std::string> laws_never_asked(const Plan& plan, const std::vector<PointResult>& points);

}  // namespace flyrock
