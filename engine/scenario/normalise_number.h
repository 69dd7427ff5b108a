#pragma once
// Normalises numbers: quantities with units, distributions, limits.

#include <optional>
#include <string>
#include <string_view>

#include "document/value.h"
#include "scenario/decode_context.h"

namespace flyrock {

/// Which forms a number may have at its place.
struct NumberRules {
  bool varies = false;              ///< may be a distribution
  Scope scope = Scope::trial;       ///< scope of a distribution without `per`
  Scope finest = Scope::trial;      ///< finest scope that `per` may ask for
  bool bare_angles = false;         ///< `expect`: angles without a unit are rad
  bool limits_gain = false;         ///< restitution: `allow_gain` lifts the limit 1 of its numbers
  std::string_view over_time = {};  ///< the parameter that may be a table over time; empty: none
};

/// A constant, converted to SI units, without its limits; sweeps and distributions are refused. `expected` is
/// text such as "a number in m".
std::optional<double> quantity_of(DecodeContext& context, const Node& node, const Dimension& dimension,
                                  const NumberRules& rules, const std::string& expected);

/// A number within the limits of `spec` (type number or integer), or a distribution of such numbers with its
/// scope. Null if it is wrong.
Value normalise_number(DecodeContext& context, const Node& node, const ParamSpec& spec,
                       const NumberRules& rules);

/// A distribution without `per`; nothing if it is wrong.
std::optional<Map> normalise_distribution(DecodeContext& context, const Node& node, const ParamSpec& spec,
                                          const NumberRules& rules);

/// The distribution of a normalised map.
Distribution read_distribution(const Value& normalised);

/// Why a number of the document is not the whole number `si` that was read: it has more digits than a double.
/// Empty if it is.
std::string digits_fault(const Value& value, double si);

/// The SI value of a normalised constant.
double si_of(const Value& normalised);

/// What a parameter takes: "a number in m/s", "a whole number", "`on` or `off`".
std::string expected_text(const ParamSpec& spec);

/// A value given in SI units, as messages about a parameter show it: in the declared unit, "12 m/s".
std::string with_unit(double si, const ParamSpec& spec);

/// Why values from `low` to `high` are outside the limits of `spec`; empty if they are inside. The ends of an
/// open interval (of a continuous distribution) are never drawn.
std::string limit_fault(const ParamSpec& spec, double low, double high, bool is_open = false);

/// A number as the normalised tree writes it: without a unit, an angle as "1.2 rad".
Value number_value(double si, const Dimension& dimension);
Value text_value(std::string text);
Value list_value(List list);
Value map_value(Map map);
/// Appends an entry to a map of the normalised tree.
void put(Map& map, std::string_view key, Value value);
/// The same for what a key of the document says, at its place.
void put(Map& map, const Node& from, Value value);
/// Appends all entries of another map.
void put_all(Map& map, Map others);

}  // namespace flyrock
