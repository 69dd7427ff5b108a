#include "results/contact_measure.h"

#include <fmt/format.h>

#include <algorithm>

namespace flyrock {

namespace {

/// A quantity of the pair in one step.
struct Instant {
  double time = 0, step = 0;
  double value = 0;
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
    if (instants.empty() || instants.back().time != row.time) {
      instants.push_back({row.time, row.step, value, row.gap});
    } else if (is_force) {
      instants.back().value += value;
    } else if (row.gap < instants.back().gap) {
      instants.back().value = value;
      instants.back().gap = row.gap;
    }
  }
  return instants;
}

}  // namespace

ContactMeasure::Answer ContactMeasure::value(const std::vector<SeriesContact>& rows) const {
  const std::vector<Instant> instants = instants_of(*this, rows);
  if (instants.empty()) return {0, fmt::format("{} and {} have no contact in a step", a, b)};
  const auto less = [](const Instant& l, const Instant& r) { return l.value < r.value; };
  if (of_time == "final") return {instants.back().value, {}};
  if (of_time == "max") return {std::max_element(instants.begin(), instants.end(), less)->value, {}};
  if (of_time == "min") return {std::min_element(instants.begin(), instants.end(), less)->value, {}};
  if (of_time == "at") {
    for (const Instant& instant : instants)
      if (time <= instant.time && time > instant.time - instant.step) return {instant.value, {}};
    return {0, fmt::format("{} and {} have no contact at {} s", a, b, time)};
  }
  double sum = 0, duration = 0;
  for (const Instant& instant : instants) {
    sum += instant.step * instant.value;
    duration += instant.step;
  }
  return {sum / duration, {}};
}

}  // namespace flyrock
