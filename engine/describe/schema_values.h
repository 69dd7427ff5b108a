#pragma once
// The JSON Schema of the values of parameters: quantities with units, distributions, sweeps, choices.
//
// A schema is looser than `flyrock check` where JSON Schema cannot say it: limits hold for bare numbers, not
// for texts with a unit, and of a unit with several factors only the form is checked.

#include <nlohmann/json.hpp>
#include <string>

#include "plugin/spec.h"

namespace flyrock::cli {

/// Where a value stands, which decides the forms that it may have.
struct ValuePlace {
  int dimension = 2;       ///< components of vectors and points
  bool varies = false;     ///< may be a distribution
  bool may_sweep = false;  ///< may be a sweep
};

/// Makes schemas, and collects those that are used in several places.
class SchemaValues {
 public:
  using Json = nlohmann::ordered_json;

  /// What a parameter takes, with its documentation and default.
  Json parameter(const ParamSpec& spec, const ValuePlace& place);
  /// `value`, or a sweep that lists such values.
  Json or_sweep(Json value, const ValuePlace& place);
  /// A text that is not empty.
  static Json some_text();
  /// An object that has these keys and no other ones.
  static Json object(Json properties, Json required);

  /// Stores a schema under a name made of letters, digits and `_`; a reference to it.
  Json define(const std::string& name, Json schema);
  static Json reference(const std::string& name);
  const Json& definitions() const { return definitions_; }

 private:
  Json value(const ParamSpec& spec, const ValuePlace& place);
  Json number(const ParamSpec& spec, const ValuePlace& place);
  Json constant(const ParamSpec& spec);
  Json distribution(const ParamSpec& spec, const ValuePlace& place);
  Json records(const ParamSpec& spec, const ValuePlace& place);
  Json layer();
  Json points(const ParamSpec& spec, int coordinates, const ValuePlace& place);

  Json definitions_ = Json::object();
};

}  // namespace flyrock::cli
