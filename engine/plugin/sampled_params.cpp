#include "plugin/sampled_params.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plugin/gain.h"
#include "units/units.h"

namespace flyrock {

namespace {

// Range of a whole number without an upper limit; small, because counts are usually small
constexpr double steps = 6;
// Largest number of optional parameters for which every choice is tried
constexpr std::size_t all_choices = 6;
constexpr std::size_t most_choices = 64;
constexpr int most_samples = 100;  // attempts to satisfy the bounds

struct Range {
  std::optional<double> low, high;

  void at_least(double limit) { low = std::max(low.value_or(limit), limit); }
  void at_most(double limit) { high = std::min(high.value_or(limit), limit); }
  void keep(BoundRelation relation, double other) {
    if (relation == BoundRelation::at_least || relation == BoundRelation::above)
      at_least(other);
    else
      at_most(other);
  }
};

/// The range that the numbers of `values` leave for parameter `i`.
Range bounds_of(const PluginSpec& spec, std::size_t i, const std::vector<ParamValue>& values) {
  Range range;
  const auto number = [&](std::size_t k) -> std::optional<double> {
    if (k >= values.size() || k == i || values[k].numbers.empty()) return std::nullopt;
    return values[k].numbers.front().constant;
  };
  for (const ParamBound& bound : spec.params[i].bounds)
    if (const auto other = number(static_cast<std::size_t>(spec.find(bound.other))))
      range.keep(bound.relation, *other);
  for (std::size_t k = 0; k < spec.params.size(); ++k)
    for (const ParamBound& bound : spec.params[k].bounds)
      if (const auto other = number(k); other && bound.other == spec.params[i].name)
        range.keep(converse(bound.relation), *other);
  return range;
}

double sample_number(const ParamSpec& spec, const Range& bounds, RandomStream& rng) {
  const bool whole = spec.type == ParamType::integer;
  const double open = whole ? steps : 1;
  Range range{spec.min ? spec.min : spec.above, spec.max ? spec.max : spec.below};
  if (const double centre = std::abs(spec.default_number.value_or(0)); centre > 0 && !whole) {
    range.low = std::max(range.low.value_or(-2 * centre), *spec.default_number - centre / 2);
    range.high = std::min(range.high.value_or(2 * centre), *spec.default_number + centre);
  }
  if (bounds.low) {
    if (range.high && *range.high < *bounds.low)
      range.high = spec.max ? spec.max : spec.below;  // far from the default
    range.at_least(*bounds.low);
  }
  if (bounds.high) {
    if (range.low && *range.low > *bounds.high) range.low = spec.min ? spec.min : spec.above;
    range.at_most(*bounds.high);
  }
  if (!range.low) range.low = range.high ? *range.high - open : -open;
  if (!range.high) range.high = *range.low + open;
  if (whole) range.high = std::min(*range.high, *range.low + steps);
  return whole ? static_cast<double>(rng.integer(std::llround(*range.low), std::llround(*range.high)))
               : rng.uniform(*range.low, *range.high);
}

/// Three points within the limits of their components, with increasing first components.
std::vector<std::vector<double>> points_within(const ParamSpec& spec, std::size_t components,
                                               RandomStream& rng) {
  std::vector<std::vector<double>> points(3);
  for (std::size_t k = 0; k < components; ++k)
    for (std::vector<double>& point : points)
      point.push_back(sample_number(k < spec.fields.size() ? spec.fields[k] : ParamSpec(), {}, rng));
  std::sort(points.begin(), points.end());
  return points;
}

/// "12.5 m/s"
std::string number_text(double si, const ParamSpec& param) {
  if (param.type == ParamType::boolean) return si != 0 ? "true" : "false";
  if (param.unit.empty()) return fmt::format("{:.6g}", si);
  return fmt::format("{:.6g} {}", si / parse_unit(param.unit)->factor, param.unit);
}

std::string value_text(const ParamSpec& param, const ParamValue& value, Values numbers) {
  if (!value.text.empty() || param.type == ParamType::text) return value.text;
  std::vector<std::string> items;
  for (const double number : numbers) items.push_back(number_text(number, param));
  for (const std::vector<double>& point : value.points)
    items.push_back(fmt::format("[{:.6g}]", fmt::join(point, ", ")));
  const std::string list = fmt::format("{}", fmt::join(items, ", "));
  return numbers.size() == 1 ? list : "[" + list + "]";
}

}  // namespace

bool can_sample(const ParamSpec& spec) {
  constexpr ParamType never[] = {ParamType::text, ParamType::file, ParamType::shapes, ParamType::records,
                                 ParamType::law};
  return std::find(std::begin(never), std::end(never), spec.type) == std::end(never) &&
         spec.name != allow_gain;  // the engine reads it: an answer within its limits does not depend on it
}

bool can_sample(const PluginSpec& spec) {
  return std::all_of(spec.params.begin(), spec.params.end(),
                     [](const ParamSpec& param) { return !param.required() || can_sample(param); });
}

ParamValue sample_param(const PluginSpec& plugin, std::size_t i, const std::vector<ParamValue>& values,
                        int dimension, RandomStream& rng) {
  const ParamSpec& spec = plugin.params[i];
  const Range bounds = bounds_of(plugin, i, values);
  ParamValue value;
  value.given = true;
  switch (spec.type) {
    case ParamType::number:
    case ParamType::integer:
      value.numbers = {{sample_number(spec, bounds, rng)}};
      break;
    case ParamType::boolean:
      value.numbers = {{static_cast<double>(rng.integer(0, 1))}};
      break;
    case ParamType::vector:
    case ParamType::spin:
      for (int k = 0; k < (spec.type == ParamType::spin && dimension == 2 ? 1 : dimension); ++k)
        value.numbers.push_back({sample_number(spec, bounds, rng)});
      break;
    case ParamType::choice:
      value.text = spec.choices[rng.integer(0, static_cast<std::int64_t>(spec.choices.size()) - 1)];
      break;
    case ParamType::points:
      if (!spec.fields.empty())
        value.points = points_within(spec, static_cast<std::size_t>(dimension), rng);
      else if (dimension == 2)
        value.points = {{0, 0}, {2, -rng.uniform()}, {3, rng.uniform()}};
      else
        value.points = {{0, 0, 0}, {2, -rng.uniform(), 0}, {3, rng.uniform(), 0}, {1, 0, 1 + rng.uniform()}};
      break;
    case ParamType::plan_points:  // long and nearly straight: lines beside it do not cross
      if (!spec.fields.empty())
        value.points = points_within(spec, 2, rng);
      else
        value.points = {{0, 0}, {1000, -rng.uniform()}, {3000, rng.uniform()}};
      break;
    case ParamType::text:
    case ParamType::file:
    case ParamType::shapes:
    case ParamType::records:
    case ParamType::law:
      value = {};
      break;
  }
  return value;
}

bool keeps_bounds(const PluginSpec& spec, const std::vector<ParamValue>& values) {
  for (std::size_t i = 0; i < spec.params.size(); ++i)
    for (const ParamBound& bound : spec.params[i].bounds) {
      const auto &own = values[i].numbers,
                 &other = values[static_cast<std::size_t>(spec.find(bound.other))].numbers;
      if (!own.empty() && !other.empty() && !keeps(own[0].constant, bound.relation, other[0].constant))
        return false;
    }
  return true;
}

namespace {

/// Samples the given parameters in their order. Each satisfies its bounds to the parameters before it.
std::vector<ParamValue> sample_given(const PluginSpec& spec, const std::vector<bool>& given,
                                     const std::vector<ParamValue>& fixed, int dimension, RandomStream& rng) {
  std::vector<ParamValue> values;
  for (std::size_t i = 0; i < spec.params.size(); ++i) {
    if (is_given(fixed, i)) {
      values.push_back(fixed[i]);
      continue;
    }
    values.push_back(given[i] ? sample_param(spec, i, values, dimension, rng) : ParamValue{});
    if (!given[i] && spec.params[i].default_text && spec.params[i].group().empty()) {
      values.back().given = true;
      values.back().text = *spec.params[i].default_text;
    }
  }
  return values;
}

}  // namespace

std::vector<std::vector<ParamValue>> sample_variants(const PluginSpec& spec, int dimension, RandomStream& rng,
                                                     const std::vector<ParamValue>& fixed) {
  for (std::size_t i = 0; i < spec.params.size(); ++i)
    if (spec.params[i].required() && !can_sample(spec.params[i]) && !is_given(fixed, i)) return {};
  // What may be left out: a parameter, or a group of parameters, which its first one stands for.
  std::vector<std::size_t> varied;
  for (std::size_t i = 0; i < spec.params.size(); ++i) {
    const std::string_view group = spec.params[i].group();
    const bool opens_group = !group.empty() && (i == 0 || spec.params[i - 1].group() != group);
    if (opens_group || (group.empty() && spec.params[i].optional && can_sample(spec.params[i])))
      varied.push_back(i);
  }
  const bool all = varied.size() <= all_choices;
  const std::size_t choices = all ? std::size_t{1} << varied.size() : most_choices;

  std::vector<std::vector<ParamValue>> variants;
  for (std::size_t choice = 0; choice < choices; ++choice) {
    std::vector<bool> given;
    for (const ParamSpec& param : spec.params)
      given.push_back(!param.optional && param.group().empty() && can_sample(param));
    for (std::size_t place = 0; place < varied.size(); ++place) {
      const bool is_given =
          all ? (choice >> place & 1) != 0 : choice == 1 || (choice > 1 && rng.integer(0, 1) == 1);
      const std::string_view group = spec.params[varied[place]].group();
      for (std::size_t i = varied[place]; i < spec.params.size(); ++i)
        if (i == varied[place] || (!group.empty() && spec.params[i].group() == group))
          given[i] = is_given && can_sample(spec.params[i]);
    }
    auto values = sample_given(spec, given, fixed, dimension, rng);
    for (int more = 1; more < most_samples && !keeps_bounds(spec, values); ++more)
      values = sample_given(spec, given, fixed, dimension, rng);
    if (keeps_bounds(spec, values)) variants.push_back(std::move(values));
  }
  return variants;
}

std::string parameters_text(const PluginSpec& spec, const std::vector<ParamValue>& values, Values numbers) {
  std::vector<std::string> texts;
  std::size_t slot = 0;
  for (std::size_t i = 0; i < spec.params.size(); ++i) {
    const ParamValue& value = values[i];
    if (value.given)
      texts.push_back(spec.params[i].name + " = " +
                      value_text(spec.params[i], value, numbers.subspan(slot, value.numbers.size())));
    slot += value.numbers.size();
  }
  return texts.empty() ? "none" : fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace flyrock
