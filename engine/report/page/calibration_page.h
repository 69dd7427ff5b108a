#pragma once
// calibration.html: what `flyrock calibrate` found, as one page that needs no script.

#include <string>

#include "report/tables/calibration_data.h"

namespace flyrock {

/// The answer in sentences, the map of the misfit with the region, both distributions, each row on the band
/// of its own trials, and the same of what was held back. The same calibration gives the same bytes.
std::string calibration_page(const FittedModel& model);

}  // namespace flyrock
