#include "blast/derived.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "blast/mckenzie.h"

namespace flyrock {

namespace {

using enum BlastField;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

int row_of(const Pattern& pattern, int hole) {
  return pattern.measured.empty() ? pattern.row(hole) : pattern.measured[static_cast<std::size_t>(hole)].row;
}

double mean(const std::vector<DerivedNumbers>& holes, std::size_t which, const std::vector<double>& weights) {
  double sum = 0, all = 0;
  for (std::size_t i = 0; i < holes.size(); ++i) {
    if (std::isnan(holes[i][which])) continue;
    sum += weights[i] * holes[i][which];
    all += weights[i];
  }
  return all > 0 ? sum / all : none;
}

}  // namespace

const std::array<DerivedInfo, derived_count>& derived_infos() {
  static const std::vector<BlastField> volume{hole_charge, burden, spacing, hole_length, hole_subdrilling};
  static const std::vector<BlastField> mass{hole_charge, burden,           spacing,
                                            hole_length, hole_subdrilling, rock_density};
  static const std::array<DerivedInfo, derived_count> infos{{
      {"powder_factor", "kg/m3", volume},
      {"powder_factor_by_mass", "kg/t", mass},
      {"charge_ratio", "1", {hole_linear_charge, burden, breakout_angle, rock_density}},
      {"charge", "kg", {hole_charge}},
      {"scaled_burden", "m/(kg/m)^0.5", {burden, hole_linear_charge}},
      {"scaled_depth", "m/kg^(1/3)", {hole_stemming, hole_charge_length, hole_diameter, explosive_density}},
      {"burden_to_diameter", "1", {burden, hole_diameter}},
      {"stemming_to_burden", "1", {hole_stemming, burden}},
      {"delay_per_burden", "ms/m", {burden}, true},
  }};
  return infos;
}

DerivedNumbers derived_numbers(const Blast& blast, const Pattern& pattern, int hole, double delay) {
  DerivedNumbers numbers;
  const auto put = [&](Derived derived, double value) { numbers[static_cast<std::size_t>(derived)] = value; };
  const double b = blast[burden], charge = blast[hole_charge];
  const BlastDesign design = design_of(blast, Pattern{});
  double factor = design.powder_factor;
  if (pattern.measured.empty() && pattern.row(hole) > 0 && pattern.row_distance > 0)
    factor *= b / pattern.row_distance;  // of rows behind the first
  put(Derived::powder_factor, factor);
  put(Derived::powder_factor_by_mass, 1000 * factor / blast[rock_density]);
  put(Derived::charge_ratio, design.charge_to_mass);
  put(Derived::charge, charge);
  put(Derived::scaled_burden, b / std::sqrt(blast[hole_linear_charge]));
  put(Derived::scaled_depth, design.depth_of_burial);
  put(Derived::burden_to_diameter, b / blast[hole_diameter]);
  put(Derived::stemming_to_burden, blast[hole_stemming] / b);
  put(Derived::delay_per_burden, 1000 * delay / b);
  for (double& number : numbers)
    if (!std::isfinite(number)) number = none;
  return numbers;
}

DerivedNumbers derived_of_blast(const std::vector<DerivedNumbers>& holes, const std::vector<double>& rock) {
  const std::vector<double> equal(holes.size(), 1);
  const bool is_known = std::all_of(rock.begin(), rock.end(),
                                    [](double volume) { return std::isfinite(volume) && volume > 0; });
  DerivedNumbers blast;
  for (std::size_t d = 0; d < derived_count; ++d) {
    const bool is_plain = d == static_cast<std::size_t>(Derived::charge) ||
                          d == static_cast<std::size_t>(Derived::delay_per_burden);
    blast[d] = mean(holes, d, is_plain || !is_known ? equal : rock);
  }
  return blast;
}

std::vector<double> delays_in_rows(const Pattern& pattern, const std::vector<double>& times) {
  std::vector<std::size_t> order(times.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto row = [&](std::size_t hole) { return row_of(pattern, static_cast<int>(hole)); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return row(a) != row(b) ? row(a) < row(b) : times[a] < times[b];
  });
  std::vector<double> delays(times.size(), none);
  for (std::size_t i = 1; i < order.size(); ++i)
    if (row(order[i]) == row(order[i - 1])) delays[order[i]] = times[order[i]] - times[order[i - 1]];
  return delays;
}

}  // namespace flyrock
