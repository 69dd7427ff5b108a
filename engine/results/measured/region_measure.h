#pragma once
// Measures of a region over the steps of a series.
//
// region.<name>.<porosity|stress_xx|...>.<mean|max|min|final|at[time]>

#include <string>
#include <vector>

#include "record/series.h"
#include "results/measured/over_steps.h"

namespace flyrock {

struct RegionMeasure {
  std::string region;
  double SeriesRegion::*quantity = nullptr;
  OverSteps over;

  OverSteps::Answer value(const std::vector<SeriesRegion>& rows) const {
    std::vector<OverSteps::Instant> instants;
    for (const SeriesRegion& row : rows)
      if (row.region == region) instants.push_back({row.time, row.step, row.*quantity});
    return over.of(instants, "the region " + region + " has no row");
  }
};

}  // namespace flyrock
