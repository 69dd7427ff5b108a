#pragma once
// The probability that at least one real rock of a blast does something, from simulated rocks that each stand
// for w real ones.
//
// y_t = prod (1 - h_i) over the simulated rocks of trial t: the probability that none of them does it. h_i is
// 1 or 0 for gates and barriers, the probability of a hit for exposures. S = 1 - mean y_t. The real rocks of
// a blast share its draws (burden, branch) as the simulated ones do. Given these draws they are independent:
// if the simulated rocks miss with the probability Y, the real ones miss with Y^w. The truth 1 - E[Y^w] is
// not known without knowing what is shared, but bounded (Jensen), for w >= 1:
//   L = 1 - mean prod (1 - h_i)^w_i  <=  truth  <=  U = 1 - (1 - S)^w.
// U holds with equality where rocks share nothing. For gates L = S. For w = 1 all three are the same. For
// w < 1, y^w is concave and the bounds change places. U is the answer, because it is on the safe side.

#include <span>

#include "load/weight_check.h"
#include "results/statistics/share.h"

namespace flyrock {

/// What the trials say of a set of rocks: all rocks, or those of a group.
struct SimulatedBlasts {
  double share = 0;         ///< S
  Interval share_interval;  ///< of S
  double product = 0;       ///< 1 - mean prod (1 - h_i)^w_i
  Interval product_interval;
  WeightRange weights;  ///< of the rocks of the set
  WeightRange doing;    ///< of those with h_i > 0; empty if there are none
};

/// Bounds of the truth, and the interval from the lower end of L to the upper end of S carried through.
struct BlastBounds {
  double lower = 0, upper = 0;
  Interval interval;
  double weight = 1;  ///< the greatest of the rocks that count

  /// Whether the bounds are so close that U is an answer.
  bool tells() const;
};

/// Bounds further apart than this factor do not tell the probability. Up to this weight they always do,
/// because U <= w S and L >= S.
inline constexpr double telling_ratio = harmless_weight;

/// 1 - (1 - p)^w; p itself for w = 1.
double carried(double p, double weight);

inline constexpr BlastBounds unknown_bounds{unknown, unknown, unknown_interval, 1};

BlastBounds bounds_of(const SimulatedBlasts& rocks);

/// The bounds of all rocks, where the weights of several groups differ: U is that of the greatest weight
/// (`all`), or the sum of the groups' U, whichever is less; L is the greatest of theirs.
BlastBounds over_groups(const BlastBounds& all, std::span<const BlastBounds> groups);

/// A weight with which the bounds would tell, or nearly so, rounded down to tenths; 1 where rocks stand for
/// less than one.
///
/// The greater one of two holds. Where nothing is known but L and U: S is then at least 1 - (1 - L)^(1/n), so
/// U / L is at most L / (1 - (1 - L)^(1/n)). Where landings are spread over a kernel: a radius that holds a
/// fixed number of landings makes h_i grow as 1/n, so U / L - 1 is in proportion to 1 - 1/n.
double telling_weight(const BlastBounds& bounds);

}  // namespace flyrock
