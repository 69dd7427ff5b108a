#pragma once
// How far a model's greatest throws are from those that were measured, a row a blast: what matters for people
// is not the mean, but how often and by how much the model falls short.

#include <optional>
#include <vector>

#include "results/statistics/rank_correlation.h"
#include "results/statistics/share.h"

namespace flyrock {

/// A blast: the farthest rock that was found, and the median over the trials of the farthest of the model
/// [m].
struct Throw {
  double measured = 0, model = 0;
};

/// The factor by which the model's distances cover a share of the blasts: that quantile of measured / model,
/// with its interval.
struct CoveringFactor {
  double covers = 0.95;
  double factor = 0;
  Interval interval;
};

/// One factor for the site: fitted on every other blast, so that it covers 95 % of them, and judged on the
/// rest.
struct SiteFactor {
  double factor = 0;
  std::size_t fitted = 0;  ///< blasts
  Share covered;           ///< of the others: those that the factor covers
  std::size_t judged = 0;
};

struct ThrowSummary {
  std::size_t blasts = 0;
  Share short_of;                       ///< blasts whose farthest rock flew farther than the model says
  std::vector<CoveringFactor> factors;  ///< for 50, 95 and 99 %
  RankCorrelation rank;                 ///< does the model order the blasts?
  Interval rank_interval;
  std::optional<SiteFactor> site;  ///< absent: too few blasts
};

/// Blasts of which the model throws nothing are to be left out. The order decides which blasts fit the site's
/// factor: the first, the third, ...
ThrowSummary summary_of(const std::vector<Throw>& throws);

}  // namespace flyrock
