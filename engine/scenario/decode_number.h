#pragma once
// A value of the tree to a number: quantities with units, distributions, limits.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "document/node.h"
#include "plugin/registry.h"

namespace flyrock {

/// What all parts of the decoder share while they decode one point of a sweep.
struct DecodeContext {
  const Registry& registry;
  std::string folder;  ///< of the scenario, for files that it names
  Diagnostics& diagnostics;
  const std::set<std::string>& swept;  ///< paths of the sweep's axes
  bool a_plugin_failed = false;        ///< to load, which was reported: an unknown name is no news then
  int dimension = 2;
  std::vector<Draw> draws = {};
  struct SweptNumber {
    double si = 0;
    std::string unit;  ///< SI
  };
  std::map<std::string, SweptNumber> swept_values = {};  ///< by path; of the axes met where a sweep may stand
  std::map<std::string, std::string> files = {};  ///< that parameters name: as written, and the full path
};

/// What a number may be where it stands.
struct NumberRules {
  bool varies = false;          ///< may be a distribution or swept
  Scope scope = Scope::trial;   ///< of a distribution without `per`
  Scope finest = Scope::trial;  ///< the finest that `per` may ask for
  bool bare_angles = false;     ///< `expect`: angles without a unit are rad
};

/// A constant without limits, sweeps and distributions; [SI]. `expected` is "a number in m".
std::optional<double> decode_quantity(DecodeContext& context, const Node& node, const Dimension& dimension,
                                      const NumberRules& rules, const std::string& expected);

/// A number within the limits of `spec` (type number or integer). The resolved value is in SI units.
struct DecodedNumber {
  Number number;
  Value resolved;
};
std::optional<DecodedNumber> decode_number(DecodeContext& context, const Node& node, const ParamSpec& spec,
                                           const NumberRules& rules);

/// A distribution as it was written, in SI units, and its normal form without `per`.
struct DecodedDistribution {
  Distribution distribution;
  Map resolved;
};
std::optional<DecodedDistribution> decode_distribution(DecodeContext& context, const Node& node,
                                                       const ParamSpec& spec, const NumberRules& rules);

/// What a parameter takes: "a number in m/s", "a whole number", "`on` or `off`".
std::string expected_text(const ParamSpec& spec);

/// A value in SI as messages about a parameter show it, in the unit that is declared: "12 m/s".
std::string with_unit(double si, const ParamSpec& spec);

/// Why values from `low` to `high` are outside the limits of `spec`, or an empty text. The ends of an open
/// interval (a continuous distribution) are never drawn.
std::string limit_fault(const ParamSpec& spec, double low, double high, bool is_open = false);

/// A number as the resolved scenario writes it: bare, an angle as "1.2 rad".
Value number_value(double si, const Dimension& dimension);
Value text_value(std::string text);
Value list_value(List list);
Value map_value(Map map);
/// Appends an entry to a resolved map.
void put(Map& map, std::string_view key, Value value);

}  // namespace flyrock
