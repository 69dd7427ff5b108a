#pragma once
// All results of a run. The tables, the report and the terminal show them.

#include <functional>
#include <string>
#include <vector>

#include "record/rows.h"
#include "results/compare/best_point.h"
#include "results/compare/differences.h"
#include "results/compare/expectations.h"
#include "results/measured/measures.h"

namespace flyrock {

struct Plan;

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
  std::vector<PointDifferences> differences;  ///< of the points after point 0; empty without a sweep of rocks
  std::optional<BestPoint> best;              ///< where the scenario has an `answer`
  std::vector<std::string>
      warnings;  ///< what may make the numbers wrong: from the solver, the reader, the launches
  std::vector<std::string>
      not_asked;              ///< laws that no contact needed; keys that are not read are in Plan::not_used
  std::vector<Fault> faults;  ///< the first 20
  std::uint64_t fault_count = 0;
  std::string ended_early;  ///< why; empty if every trial ran

  std::uint64_t rocks() const;
  /// The number of verdicts with this judgement.
  int count(Judgement judgement) const;
};

/// How the records were produced.
struct RunFacts {
  std::vector<std::uint64_t> trials;  ///< trials that ran, for each point
  bool full = true;                   ///< false if the scenario itself asks for more; see judge()
  std::string ended_early;            ///< why, or empty
  std::vector<std::string> warnings;  ///< from the reader of the scenario
};

class PointTally;

/// Reads the rows of a point, together with the tally of its results: a pass costs much more to read than to
/// look at once more.
class RowReader {
 public:
  virtual ~RowReader() = default;
  virtual void add(const TrialRecords& chunk) = 0;
  virtual bool needs_another_pass() = 0;
};

/// The reader for a point, or none. `runouts`: of all rocks, then of each group if there is more than one.
using ReaderOfPoint = std::function<RowReader*(std::size_t point, const std::vector<RunoutExtent>& runouts)>;

/// Computes the results of a run: in a first pass, which may take place during the run, and in further passes
/// over the rows.
class ResultTally {
 public:
  explicit ResultTally(const Plan& plan);
  ~ResultTally();

  /// Takes the chunks of all points in order, with all their rows.
  void add(int point, const TrialRecords& chunk);
  /// Reads the same chunks again, and shows them to another reader of each point. Throws FileError if a chunk
  /// cannot be read.
  Results finish(const std::vector<Rows>& rows, const RunFacts& facts, const ReaderOfPoint& reader = {});

 private:
  const Plan& plan_;
  Results results_;
  std::vector<PointTally> tallies_;
};

/// All passes in one call, over the rows of each point.
Results make_results(const Plan& plan, const std::vector<Rows>& rows, const RunFacts& facts,
                     const ReaderOfPoint& reader = {});

/// The laws that no contact of any point needed: "material haul_floor: its restitution pfeiffer_bowen was
/// never asked".
std::vector<std::string> laws_never_asked(const Plan& plan, const std::vector<PointResult>& points);

}  // namespace flyrock
