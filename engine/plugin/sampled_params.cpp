#include "plugin/sampled_params.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

namespace {

constexpr double steps = 6;  // of a whole number without an upper limit: small, as counts are
constexpr std::size_t most_varied = 10;

double sample_number(const ParamSpec& spec, RandomStream& rng) {
  const bool whole = spec.type == ParamType::integer;
  const double open = whole ? steps : 1;
  std::optional<double> low = spec.min ? spec.min : spec.above;
  std::optional<double> high = spec.max ? spec.max : spec.below;
  if (const double centre = std::abs(spec.default_number.value_or(0)); centre > 0 && !whole) {
    low = std::max(low.value_or(-2 * centre), *spec.default_number - centre / 2);
    high = std::min(high.value_or(2 * centre), *spec.default_number + centre);
  }
  if (!low) low = high ? *high - open : -open;
  if (!high) high = *low + open;
  if (whole) high = std::min(*high, *low + steps);
  return whole ? static_cast<double>(rng.integer(std::llround(*low), std::llround(*high)))
               : rng.uniform(*low, *high);
}

}  // namespace

bool can_sample(const ParamSpec& spec) {
  return spec.type != ParamType::text && spec.type != ParamType::file;
}

ParamValue sample_param(const ParamSpec& spec, int dimension, RandomStream& rng) {
  ParamValue value;
  value.given = true;
  switch (spec.type) {
    case ParamType::number:
    case ParamType::integer:
      value.numbers = {{sample_number(spec, rng)}};
      break;
    case ParamType::boolean:
      value.numbers = {{static_cast<double>(rng.integer(0, 1))}};
      break;
    case ParamType::vector:
    case ParamType::spin:
      for (int i = 0; i < (spec.type == ParamType::spin && dimension == 2 ? 1 : dimension); ++i)
        value.numbers.push_back({sample_number(spec, rng)});
      break;
    case ParamType::choice:
      value.text = spec.choices[rng.integer(0, static_cast<std::int64_t>(spec.choices.size()) - 1)];
      break;
    case ParamType::points:
      if (dimension == 2)
        value.points = {{0, 0}, {2, -rng.uniform()}, {3, rng.uniform()}};
      else
        value.points = {{0, 0, 0}, {2, -rng.uniform(), 0}, {3, rng.uniform(), 0}, {1, 0, 1 + rng.uniform()}};
      break;
    case ParamType::text:
    case ParamType::file:
      value = {};
      break;
  }
  return value;
}

std::vector<std::vector<ParamValue>> sample_variants(const PluginSpec& spec, int dimension, RandomStream& rng) {
  std::vector<std::size_t> varied;
  for (std::size_t i = 0; i < spec.params.size(); ++i) {
    const ParamSpec& param = spec.params[i];
    if (param.required() && !can_sample(param)) return {};
    if (param.optional && can_sample(param) && varied.size() < most_varied) varied.push_back(i);
  }
  std::vector<std::vector<ParamValue>> variants;
  for (std::size_t choice = 0; choice < std::size_t{1} << varied.size(); ++choice) {
    std::vector<ParamValue> values;
    for (std::size_t i = 0; i < spec.params.size(); ++i) {
      const ParamSpec& param = spec.params[i];
      const auto place = std::find(varied.begin(), varied.end(), i) - varied.begin();
      const bool given = param.optional ? choice >> place & 1 : can_sample(param);
      values.push_back(given ? sample_param(param, dimension, rng) : ParamValue{});
      if (!given && param.default_text) {
        values.back().given = true;
        values.back().text = *param.default_text;
      }
    }
    variants.push_back(std::move(values));
  }
  return variants;
}

}  // namespace flyrock
