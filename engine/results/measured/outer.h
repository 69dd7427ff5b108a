#pragma once
// How far the numbers of a scenario scatter between its runs (`outer`), each with its own draws `per: run`.
//
// A draw `per: trial` differs from blast to blast, and a longer run tells its effect better. A draw `per:
// run` is a number that nobody knows, such as a coefficient that was fitted to few measurements: within a run
// it is one number. So n runs of equally many trials are made, and each number of a run (scenario/measure.h)
// has a distribution over the n runs. It holds what is drawn `per: run` and, in addition, the chance of the
// trials of one run, which more trials make smaller.

#include <cstdint>
#include <string>
#include <vector>

#include "record/rows.h"
#include "results/measured/measures.h"
#include "results/statistics/statistics.h"
#include "scenario/measure.h"

namespace flyrock {

/// A number over the runs: its mean, standard deviation, extremes and percentiles, linear between the order
/// statistics as Sample::quantile(). Bounds of runs with censored rocks make bounds of percentiles.
struct OuterNumber {
  std::string measure = {};        ///< "rocks.runout.p95"
  std::string unit = {};           ///< SI; "1": none
  std::uint64_t runs = 0;          ///< that give it
  std::uint64_t lower_bounds = 0;  ///< of these
  Bounded mean{unknown}, sd{unknown}, min{unknown}, p5{unknown}, p50{unknown}, p95{unknown}, max{unknown};
};

struct OuterSummary {
  std::uint64_t runs = 0, trials = 0;     ///< trials: of each run
  std::uint64_t lost = 0;                 ///< runs that lost too many rocks for numbers
  std::vector<OuterNumber> numbers = {};  ///< empty if not all trials ran

  const OuterNumber* find(const std::string& measure) const;
};

/// Reads the rows of each run in passes. `names`: of what the scenario has measures of. `exposures`: of all
/// runs together, whose kernels each run takes.
OuterSummary make_outer(const Scenario& scenario, const MeasureNames& names, const Rows& rows,
                        const std::vector<ExposureSummary>& exposures);

}  // namespace flyrock
