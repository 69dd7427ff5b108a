#pragma once
// sensitivity.html: what `flyrock sensitivity` found, as one page that needs no script.

#include <string>

#include "results/statistics/explained_variance.h"

namespace flyrock {

/// The answer first; then of each number bars of total indices with the first order inside, a tornado in its
/// own unit, and curves; then the curves of all numbers over each input that several of them depend on.
std::string variance_page(const ExplainedVariance& found);

}  // namespace flyrock
