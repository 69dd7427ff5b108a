#include "results/measured/contact_measure.h"

#include <fmt/format.h>

namespace flyrock {

namespace {

/// A quantity of the pair in one step.
struct Instant {
  OverSteps::Instant at;
  double gap = 0;  ///< the least so far
};

bool is(const std::string& wanted, const std::string& name) {
  return name == wanted || (wanted == "terrain" && name.starts_with("terrain."));
}

double value_of(const SeriesContact& row, const std::string& quantity) {
  if (quantity == "gap") return row.gap;
  if (quantity == "un") return row.un;
  if (quantity == "ut") return row.ut;
  return quantity == "rn" ? row.rn : row.rt;
}

std::vector<Instant> instants_of(const ContactMeasure& measure, const std::vector<SeriesContact>& rows) {
  const bool is_force = measure.quantity == "rn" || measure.quantity == "rt";
  std::vector<Instant> instants;
  for (const SeriesContact& row : rows) {
    const bool of_pair =
        (is(measure.a, row.a) && is(measure.b, row.b)) || (is(measure.b, row.a) && is(measure.a, row.b));
    if (!of_pair || row.step <= 0) continue;
    const double value = value_of(row, measure.quantity);
    if (instants.empty() || instants.back().at.time != row.time) {
      instants.push_back({{row.time, row.step, value}, row.gap});
    } else if (is_force) {
      instants.back().at.value += value;
    } else if (row.gap < instants.back().gap) {
      instants.back().at.value = value;
      instants.back().gap = row.gap;
    }
  }
  return instants;
}

}  // namespace

OverSteps::Answer ContactMeasure::value(const std::vector<SeriesContact>& rows) const {
  std::vector<OverSteps::Instant> instants;
  for (const Instant& instant : instants_of(*this, rows)) instants.push_back(instant.at);
  return over.of(instants, fmt::format("{} and {} have no contact", a, b));
}

}  // namespace flyrock
