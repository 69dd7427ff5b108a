#include "scenario/param_bounds.h"

#include <fmt/format.h>

#include <algorithm>

#include "scenario/normalise_number.h"

namespace flyrock {

namespace {

/// The values that a parameter takes in a run.
struct Range {
  double low = 0, high = 0;
  double likely_low = 0, likely_high = 0;  ///< of an end that is infinite, without the negligible tail
  bool drawn = false;
  bool open = false;  ///< for a continuous distribution, whose ends are never drawn
};

Range range_of(const Number& number, const std::vector<Draw>& draws) {
  const double constant = number.constant;
  if (number.is_constant()) return {constant, constant, constant, constant};
  const Distribution& distribution = draws[static_cast<std::size_t>(number.draw)].distribution;
  return {.low = distribution.lowest(),
          .high = distribution.highest(),
          .likely_low = distribution.likely_lowest(),
          .likely_high = distribution.likely_highest(),
          .drawn = true,
          .open = distribution.is_continuous()};
}

bool keeps(const Range& range, BoundRelation relation, const Range& other) {
  switch (relation) {
    case BoundRelation::at_most:
      return range.likely_high <= other.likely_low;
    case BoundRelation::below:
      return range.likely_high < other.likely_low || (range.high == other.low && (range.open || other.open));
    case BoundRelation::at_least:
    case BoundRelation::above:
      return keeps(other, converse(relation), range);
  }
  return true;
}

/// "is 0.7", "draws from 0.3 to 0.7".
std::string text_of(const Range& range, const ParamSpec& spec) {
  if (!range.drawn) return "is " + with_unit(range.low, spec);
  return fmt::format("draws from {} to {}", with_unit(range.low, spec), with_unit(range.high, spec));
}

/// A parameter that the document gives.
std::optional<Node> written(const Node& map, const ParamSpec& spec) {
  const std::optional<Node> parent = spec.group().empty() ? map : map.find(spec.group());
  return parent ? find_given(*parent, spec.own_name()) : std::nullopt;
}

}  // namespace

void check_bounds(DecodeContext& context, const Node& map, const std::vector<ParamSpec>& specs,
                  const std::vector<ParamValue>& values, const std::vector<bool>& decoded) {
  const auto index_of = [&](const std::string& name) {
    return static_cast<std::size_t>(
        std::find_if(specs.begin(), specs.end(), [&](const ParamSpec& spec) { return spec.name == name; }) -
        specs.begin());
  };
  const auto range = [&](std::size_t i) { return range_of(values[i].numbers.front(), context.draws); };
  for (std::size_t i = 0; i < specs.size(); ++i)
    for (const ParamBound& bound : specs[i].bounds) {
      const std::size_t other = index_of(bound.other);
      if (!decoded[i] || !decoded[other] || keeps(range(i), bound.relation, range(other))) continue;
      // The message is about the parameter that the file gives. If only the other one is given, it states the
      // converse.
      const bool itself = written(map, specs[i]).has_value();
      const std::size_t subject = itself ? i : other, object = itself ? other : i;
      const std::optional<Node> node = written(map, specs[subject]);
      const char* by_default = written(map, specs[object]) ? "" : " by default";
      context.diagnostics.error(
          node ? node->key_at : map.key_at, node ? node->path : map.path,
          fmt::format("{}, must be {} `{}`, which {}{}", text_of(range(subject), specs[subject]),
                      name_of(itself ? bound.relation : converse(bound.relation)), specs[object].name,
                      text_of(range(object), specs[object]), by_default));
    }
}

}  // namespace flyrock
