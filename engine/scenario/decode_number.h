#pragma once
// Decodes a value of the tree into a number: quantities with units, distributions, limits.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "document/node.h"
#include "plugin/registry.h"
#include "scenario/ground_store.h"

namespace flyrock {

/// What all parts of the decoder share for one point of a sweep.
struct DecodeContext {
  const Registry& registry;
  std::string folder;  ///< of the scenario; files that it names are relative to it
  Diagnostics& diagnostics;
  const std::set<std::string>& swept;  ///< paths of the axes of the sweep
  bool a_plugin_failed = false;  ///< to load, which is already reported: unknown names are then not reported
  int dimension = 2;
  std::vector<Draw> draws = {};
  struct SweptNumber {
    double si = 0;
    std::string unit;  ///< SI
  };
  std::map<std::string, SweptNumber> swept_values =
      {};                                         ///< by path; the axes found so far where a sweep is allowed
  std::map<std::string, std::string> files = {};  ///< that parameters name: name as written -> full path
  std::shared_ptr<GroundStore> grounds = nullptr;  ///< of all points
};

/// Which forms a number may have at its place.
struct NumberRules {
  bool varies = false;          ///< may be a distribution or swept
  Scope scope = Scope::trial;   ///< scope of a distribution without `per`
  Scope finest = Scope::trial;  ///< finest scope that `per` may ask for
  bool bare_angles = false;     ///< `expect`: angles without a unit are rad
};

/// A constant, converted to SI units, without its limits; sweeps and distributions are refused. `expected` is
/// text such as "a number in m".
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

/// A value given in SI units, as messages about a parameter show it: in the declared unit, "12 m/s".
std::string with_unit(double si, const ParamSpec& spec);

/// Why values from `low` to `high` are outside the limits of `spec`; empty if they are inside. The ends of an
/// open interval (of a continuous distribution) are never drawn.
std::string limit_fault(const ParamSpec& spec, double low, double high, bool is_open = false);

/// A number as the resolved scenario writes it: without a unit, an angle as "1.2 rad".
Value number_value(double si, const Dimension& dimension);
Value text_value(std::string text);
Value list_value(List list);
Value map_value(Map map);
/// Appends an entry to a resolved map.
void put(Map& map, std::string_view key, Value value);

}  // namespace flyrock
