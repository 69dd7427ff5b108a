#pragma once
// The content of summary.json. The report shows it too.

#include <nlohmann/json_fwd.hpp>

#include "results/results.h"

namespace flyrock {

struct Plan;

/// Keys in the order of docs/results.md. Numbers that do not exist are null.
nlohmann::ordered_json summary_data(const Plan& plan, const Results& results);

}  // namespace flyrock
