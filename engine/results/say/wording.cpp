#include "results/say/wording.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scenario/plan.h"
#include "units/units.h"

namespace flyrock {

namespace {

std::string hundredths(double share) { return fmt::format("{:.3g}", 100 * share); }

/// "95 % interval 210 to 226 m": the ends as numbers by `digits`, then their unit.
template <class Digits>
std::string interval_text(const Interval& interval, double confidence, const char* unit, Digits digits) {
  if (interval.trials_needed > 0)
    return fmt::format("too few trials for an interval: about {}", interval.trials_needed);
  const std::string name = percent(confidence) + " interval ";
  if (std::isnan(interval.lower) && std::isnan(interval.upper)) return name + "not known";
  if (std::isnan(interval.upper)) return fmt::format("{}from {}{} on", name, digits(interval.lower), unit);
  if (std::isnan(interval.lower) || interval.lower == 0)
    return fmt::format("{}up to {}{}", name, digits(interval.upper), unit);
  const std::string lower = digits(interval.lower), upper = digits(interval.upper);
  if (lower == upper) return name + "narrower than the last digit";
  return fmt::format("{}{} to {}{}", name, lower, upper, unit);
}

}  // namespace

std::string three_digits(double value) {
  if (value == 0 || !std::isfinite(value)) return fmt::format("{:g}", value);
  const double step = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2);
  return fmt::format("{:.10g}", std::round(value / step) * step);
}

std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

std::string with_interval(const Bounded& number, const Interval& interval, double confidence) {
  if (std::isnan(number.value)) return "not known";
  return fmt::format("{}{} m ({})", number.censored ? ">= " : "", three_digits(number.value),
                     interval_text(interval, confidence, " m", three_digits));
}

std::string display(const Share& share) {
  if (std::isnan(share.value)) return "-";
  return fmt::format("{}{} ({})", share.censored ? ">= " : "", percent(share.value),
                     interval_text(share.interval, stated_confidence, " %", hundredths));
}

std::string telling_text(const BlastBounds& bounds) {
  return fmt::format("weight {:g}{} would tell", telling_weight(bounds), bounds.weight > 1 ? " or less" : "");
}

std::string display_per_trial(const Shares& shares) {
  const BlastBounds& bounds = shares.blast;
  if (bounds.tells()) return display(shares.per_trial);
  return fmt::format("{}between {} and {} ({}; {})", shares.per_trial.censored ? ">= " : "",
                     hundredths(bounds.lower), percent(bounds.upper),
                     interval_text(bounds.interval, stated_confidence, " %", hundredths),
                     telling_text(bounds));
}

std::string value_text(const SweepAxis& axis, double value) {
  if (axis.is_choice()) return axis.label(value);
  const ReadableUnit unit = readable_unit(axis.unit);
  return fmt::format("{:.6g}{}{}", unit.per_si * value, unit.name.empty() ? "" : " ", unit.name);
}

namespace {

/// The values of a point, each after the name of its axis and `between`; of a row its label alone.
template <class NameOf>
std::string values_text(const Plan& plan, std::size_t point, const char* between, NameOf name_of_axis) {
  std::vector<std::string> values;
  for (std::size_t a = 0; a < plan.axes.size(); ++a) {
    const SweepAxis& axis = plan.axes[a];
    const std::string value = value_text(axis, plan.at[point][a]);
    if (axis.is_named) continue;
    values.push_back(axis.path == label_axis ? value : name_of_axis(axis.name) + between + value);
  }
  return fmt::format("{}", fmt::join(values, ", "));
}

}  // namespace

std::string point_text(const Plan& plan, std::size_t point) {
  return values_text(plan, point, " = ", [](const std::string& name) { return name; });
}

std::string brief_point_text(const Plan& plan, std::size_t point) {
  return values_text(plan, point, " ",
                     [](const std::string& name) { return name.substr(name.find_last_of('.') + 1); });
}

}  // namespace flyrock
