#pragma once
// Measures of a link over its steps, and over the impacts that reach it.
//
// link.<name>.<force|length|angle>.<mean|max|min|final|at[time]>, link.<name>.impulse.<mean|max|min|final>

#include <string>
#include <vector>

#include "record/series.h"
#include "results/measured/over_steps.h"

namespace flyrock {

struct LinkMeasure {
  std::string link;
  std::string quantity;  ///< force, length, angle, impulse
  OverSteps over;

  OverSteps::Answer value(const std::vector<SeriesLink>& rows) const {
    std::vector<OverSteps::Instant> instants;
    for (const SeriesLink& row : rows)
      if (row.link == link && (row.step == 0) == over.is_of_impacts)
        instants.push_back({row.time, row.step, value_of(row)});
    return over.of(instants, "the link " + link + " has no row");
  }

 private:
  double value_of(const SeriesLink& row) const {
    if (quantity == "impulse") return row.impulse;
    if (quantity == "force") return row.force;
    return quantity == "length" ? row.length : row.angle;
  }
};

}  // namespace flyrock
