#pragma once
// sensitivity.json: what `flyrock sensitivity` found (docs/results.md).

#include <nlohmann/json_fwd.hpp>

#include "results/statistics/explained_variance.h"

namespace flyrock {

/// { flyrock, scenario, ..., once_a_run, not_read, remarks } and the first number: { of, unit, answer, mean,
/// variance, inputs, sum_first, sum_total, evaluations, left_out, derived }; the others are in `also`.
nlohmann::ordered_json variance_data(const ExplainedVariance& found);

}  // namespace flyrock
