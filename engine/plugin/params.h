#pragma once
// Decoded parameters of one use of a plugin, and what a factory gets of them.

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "math/space.h"
#include "plugin/spec.h"
#include "random/distribution.h"

namespace flyrock {

/// Why a rock, or a whole trial, cannot go on. Those of this type itself no plugin is to blame for: the
/// engine cannot do what was asked. The text says what was expected.
struct TrialError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A rock that cannot start: there is no room for it, or it would start inside the ground.
struct StartError : TrialError {
  using TrialError::TrialError;
};

/// A plugin that cannot do what it was asked: a wrong parameter at construction, a law that failed. The
/// text names the plugin and says what was expected.
struct PluginError : TrialError {
  using TrialError::TrialError;
};

/// The decoded value of one declared parameter.
struct ParamValue {
  bool given = false;                       ///< false only for an optional parameter that was left out
  std::vector<Number> numbers;              ///< 1 for number, integer and boolean; one a component for vector
  std::string text;                         ///< choice, text, file (full path)
  std::vector<std::vector<double>> points;  ///< points
};

/// The numbers of a parameter list at one moment, with all draws done: slot `index` holds a parameter.
/// A parameter that takes numbers has one slot, a vector as many as it has components, others none.
using Values = std::span<const double>;

/// What a factory reads. Each name is asked once and that marks it as read: a parameter that is declared
/// and never asked for is an error of the plugin. Asking for a name or type that is not declared throws
/// PluginError. `dimension` is that of the scenario (2 or 3).
class Params {
 public:
  Params(const PluginSpec& spec, const std::vector<ParamValue>& values, int dimension);

  int dimension() const { return dimension_; }
  /// Throws PluginError where the scenario has another dimension.
  void require_dimension(int dimension) const;
  /// Whether an optional parameter was given. Does not mark it as read.
  bool given(std::string_view name) const;
  /// The slot of a number, integer or boolean, or of a spin: in 3D the first of three. An optional one that
  /// was left out is -1.
  int slot(std::string_view name);
  /// The first of the slots of a vector; -1 where it was left out.
  int vector_slot(std::string_view name);
  /// A number that must be a constant, because it decides the structure of what is built.
  double constant(std::string_view name);
  /// A choice, text or file; empty where it was left out.
  std::string text(std::string_view name);
  /// Points of as many components as the scenario has dimensions; none where they were left out.
  const std::vector<std::vector<double>>& points(std::string_view name);
  std::vector<Vec2> points2(std::string_view name);
  std::vector<Vec3> points3(std::string_view name);

  /// Declared parameters that nobody asked for.
  std::vector<std::string> unread() const;

 private:
  int at(std::string_view name, std::initializer_list<ParamType> types);

  const PluginSpec& spec_;
  const std::vector<ParamValue>& values_;
  int dimension_;
  std::vector<int> slots_;
  std::vector<bool> read_;
};

/// Whether a plugin with these parameters reads what `read` names.
bool holds(const FieldRead& read, const PluginSpec& spec, const std::vector<ParamValue>& values);

/// The slots of a parameter list in order, as Params numbers them.
std::vector<Number> dense_slots(const std::vector<ParamValue>& values);

}  // namespace flyrock
