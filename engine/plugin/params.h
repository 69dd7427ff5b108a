#pragma once
// The decoded parameters of one use of a plugin, and their interface for a factory.

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "math/space.h"
#include "plugin/spec.h"
#include "random/distribution.h"

namespace flyrock {

/// Why a rock, or a whole trial, cannot continue. An error of exactly this type is not caused by a plugin:
/// the engine cannot do what was requested. The text says what was expected.
struct TrialError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A rock cannot start, because there is no room for it or it would start inside the ground.
struct StartError : TrialError {
  using TrialError::TrialError;
};

/// A plugin failed: a wrong parameter at construction, or a failed law. The text names the plugin and says
/// what was expected.
struct PluginError : TrialError {
  using TrialError::TrialError;
};

/// The values of the parameters do not fit together. A plugin finds this only when it is called, because
/// values may be drawn. Other values within their limits may fit.
struct ParameterError : PluginError {
  using PluginError::PluginError;
};

struct ShapePart;  // plugin/registry.h

/// The decoded value of one declared parameter.
struct ParamValue {
  bool given = false;  ///< false only for an optional parameter that was left out
  /// One number for number, integer and boolean; one per component for vector; for shapes the numbers of all
  /// parts, part by part (ShapePart); for records those of all records, record by record
  std::vector<Number> numbers;
  std::string text;                                     ///< choice, text, file (full path)
  std::vector<std::vector<double>> points;              ///< points
  std::shared_ptr<const std::vector<ShapePart>> parts;  ///< shapes; null for other types
  std::vector<std::vector<ParamValue>> records = {};    ///< records: of each one, in the order of its fields
  std::shared_ptr<const Distribution> law = nullptr;    ///< law; a number is a distribution of one value
};

/// The numbers of a parameter list at one time, with all draws made. A parameter that takes numbers has one
/// slot, a vector has one slot per component, and other parameters have none.
using Values = std::span<const double>;

/// One record of a parameter of type records, for a factory. A name that its fields do not have, or of
/// another type, throws PluginError. It refers to the parameters, which must outlive it.
class ParamRecord {
 public:
  ParamRecord(const std::vector<ParamSpec>& fields, const std::vector<ParamValue>& values, int first_slot);

  bool given(std::string_view field) const;
  /// The slot of a number, integer or boolean, or the first one of a vector; -1 if it was left out.
  int slot(std::string_view field) const;
  /// A choice, text or file; empty if it was left out.
  const std::string& text(std::string_view field) const;
  const std::vector<std::vector<double>>& points(std::string_view field) const;
  /// Null if it was left out.
  std::shared_ptr<const Distribution> law(std::string_view field) const;

 private:
  std::size_t at(std::string_view field, std::initializer_list<ParamType> types) const;

  const std::vector<ParamSpec>& fields_;
  const std::vector<ParamValue>& values_;
  int first_slot_;
};

/// The parameters for a factory. Reading a parameter marks it as read, because a declared parameter that is
/// never read is an error of the plugin. Reading a name or type that is not declared throws PluginError.
/// `dimension` is the dimension of the scenario (2 or 3).
class Params {
 public:
  Params(const PluginSpec& spec, const std::vector<ParamValue>& values, int dimension);

  int dimension() const { return dimension_; }
  /// Throws PluginError if the scenario has another dimension.
  void require_dimension(int dimension) const;
  /// Whether an optional parameter was given. Does not mark it as read.
  bool given(std::string_view name) const;
  /// The slot of a number, integer, boolean or spin; for a spin in 3D the first of three. -1 for an optional
  /// parameter that was left out.
  int slot(std::string_view name);
  /// The first slot of a vector; -1 if it was left out.
  int vector_slot(std::string_view name);
  /// A number that must be a constant, because it decides the structure of what is built.
  double constant(std::string_view name);
  /// A choice, text or file, or the word in place of records; empty if it was left out.
  std::string text(std::string_view name);
  /// Points with as many components as the scenario has dimensions, points in plan with two; none if they
  /// were left out.
  const std::vector<std::vector<double>>& points(std::string_view name);
  /// The parts of a parameter of type shapes; their first slot is `first_slot`.
  const std::vector<ShapePart>& shapes(std::string_view name, int& first_slot);
  /// The records of a parameter; none if it was left out, or if one of its words stands in their place, which
  /// `text` gives.
  std::vector<ParamRecord> records(std::string_view name);
  /// What a law is; null if it was left out.
  std::shared_ptr<const Distribution> law(std::string_view name);
  std::vector<Vec2> points2(std::string_view name);
  std::vector<Vec3> points3(std::string_view name);

  /// Declared parameters that were not read.
  std::vector<std::string> unread() const;

 private:
  int at(std::string_view name, std::initializer_list<ParamType> types);

  const PluginSpec& spec_;
  const std::vector<ParamValue>& values_;
  int dimension_;
  std::vector<int> slots_;
  std::vector<bool> read_;
};

/// Whether a plugin with these parameters reads the field that `read` names.
bool holds(const FieldRead& read, const PluginSpec& spec, const std::vector<ParamValue>& values);

/// The slots of a parameter list in order, as Params numbers them.
std::vector<Number> dense_slots(const std::vector<ParamValue>& values);

}  // namespace flyrock
