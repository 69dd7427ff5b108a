#pragma once
// The manifest of a plugin: its identity, its parameters and the fields that it reads.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "units/dimension.h"
#include "units/usual.h"

namespace flyrock {

enum class PluginKind { shape, population, restitution, friction, rolling, unilateral, velocity, terrain };
inline constexpr int plugin_kinds = 8;
std::string_view name_of(PluginKind kind);
std::optional<PluginKind> plugin_kind(std::string_view name);
/// Whether it is one of the four kinds of contact laws.
bool is_law(PluginKind kind);

enum class ParamType {
  number,       ///< a real number with a unit; may be a distribution or a sweep
  integer,      ///< a whole number; may be a distribution or a sweep
  boolean,      ///< true or false
  choice,       ///< one of `choices`
  text,         ///< any text
  vector,       ///< `dimension` numbers with one unit; each may be a distribution
  points,       ///< a list of points [[x, y], ...], constant
  plan_points,  ///< the same with two coordinates in 2D and 3D: places in plan
  file,         ///< a file name relative to the scenario's folder; the host gives its full path
  spin,         ///< about z in 2D: a number; in 3D a vector in the world frame. May be a distribution
  shapes,       ///< a list of shapes, each a plugin with its parameters, its place and its turn
  records,      ///< a list of maps with the same `fields`, or a file with such a list
  law           ///< a number or a distribution, from which the plugin samples with its own random numbers
};
std::string_view name_of(ParamType type);
std::optional<ParamType> param_type(std::string_view name);

/// The relation of a parameter to another one of the same plugin.
enum class BoundRelation { at_least, above, at_most, below };
std::string_view name_of(BoundRelation relation);  ///< "at least"
/// The manifest key of a relation: "min", "above", "max", "below".
std::string_view key_of(BoundRelation relation);
/// The converse relation, of the other parameter to this one: at least, if this one is at most.
BoundRelation converse(BoundRelation relation);
/// Whether `value` has `relation` to `other`.
bool keeps(double value, BoundRelation relation, double other);

/// A limit that is another parameter: `max = "mu_s"`.
struct ParamBound {
  BoundRelation relation = BoundRelation::at_most;
  std::string other;
};

/// One declared parameter. Limits and defaults are in SI units. A parameter of a group of parameters, such as
/// the ditch of a bench, has the name "ditch.width". Without the group it is not given, and has no default.
struct ParamSpec {
  std::string name;
  ParamType type = ParamType::number;
  std::string unit;  ///< as declared, "m/s"; empty for a pure number
  /// The parameter to which the last factor of the unit is raised: "exponent" of N/m^exponent, whose `unit`
  /// and `dimension` are those of N/m.
  std::string unit_exponent;
  Dimension dimension;
  std::string doc;
  bool optional = false;                    ///< may be left out even without a default
  int needed_in = 0;                        ///< 2 or 3: an optional one that this dimension needs
  std::optional<double> default_number;     ///< number, integer, boolean (0 or 1)
  std::optional<std::string> default_text;  ///< choice, text
  std::optional<std::vector<double>> default_vector;
  std::optional<double> min, max;      ///< allowed, limits included
  std::optional<double> above, below;  ///< allowed, limits excluded
  std::vector<ParamBound> bounds;      ///< number, integer: limits that are other parameters
  std::optional<UsualRange> usual;     ///< number, integer, vector (of each component), spin
  std::vector<std::string> choices;    ///< choice: the allowed texts; number, records: words in its place
  std::vector<ParamSpec> fields = {};  ///< records: of each record; points: limits of each component
  bool single = false;                 ///< records: one record, written as a map
  bool from_file = false;              ///< records: may be the name of a YAML file or of a table

  bool required() const { return !optional && !default_number && !default_text && !default_vector; }
  bool required_in(int scenario_dimension) const { return required() || needed_in == scenario_dimension; }
  /// "ditch" of "ditch.width"; empty for a parameter outside of groups.
  std::string_view group() const;
  /// "width" of "ditch.width".
  std::string_view own_name() const;
  /// "m/s", "N/m^exponent".
  std::string unit_text() const { return unit_exponent.empty() ? unit : unit + "^" + unit_exponent; }
};

/// Maximum number of names in the history of one law. A contact reserves this space for each of its four
/// kinds of laws.
inline constexpr std::size_t most_history = 4;

/// A field of the blast or the contact that a plugin reads, always or only for certain values of a choice
/// parameter. A manifest writes "blast.burden" or "blast.burden if mode is face_burst or cratering".
struct FieldRead {
  std::string field;
  std::string param;                 ///< empty: always
  std::vector<std::string> choices;  ///< of that parameter

  bool always() const { return param.empty(); }
  std::string text() const;
};

struct PluginSpec {
  PluginKind kind = PluginKind::shape;
  std::string name;
  std::string doc;
  std::string source;                ///< the publication that the model comes from
  std::string validity;              ///< where the model is valid; outside, its note says so
  int dimension = 0;                 ///< 2 or 3: the only one it serves; 0: what its answers say
  std::string form;                  ///< restitution: "newton", "poisson", ...
  std::vector<std::string> history;  ///< names of the numbers that the law remembers
  bool history_of_contact = false;   ///< true: memory per contact; false: memory per pair of bodies
  std::vector<FieldRead> reads;      ///< "blast.burden", "contact.approach_speed"
  bool declares_reads = false;
  std::vector<ParamSpec> params;
  std::string file;    ///< the manifest file, as given to the loader
  std::string native;  ///< factory in a shared object; empty for pure Lua

  /// Index of a parameter, or -1.
  int find(std::string_view param) const;
};

}  // namespace flyrock
