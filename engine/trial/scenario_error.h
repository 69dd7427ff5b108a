#pragma once
// Errors of a scenario, with their key, while a trial is made or a plugin is tried out.

#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include "plugin/params.h"
#include "scenario/plan.h"

namespace flyrock {

/// A draw, a start or a plugin that fails. `path` is the key that caused it: "rocks.0.release".
struct ScenarioError : TrialError {
  ScenarioError(std::string at, const std::string& text, bool by_plugin = false)
      : TrialError(text), path(std::move(at)), of_plugin(by_plugin) {}
  std::string path;
  bool of_plugin;  ///< a plugin failed; otherwise the scenario asks for something impossible
};

/// The result of `call`. An error in it that does not know its key gets `path`: a text, or a function that
/// makes it, because a rock that starts needs none.
template <class Path, class Call>
decltype(auto) at_path(const Path& path, Call&& call) {
  const auto text = [&]() -> std::string {
    if constexpr (std::is_invocable_v<const Path&>)
      return path();
    else
      return path;
  };
  try {
    return std::forward<Call>(call)();
  } catch (const ScenarioError&) {
    throw;
  } catch (const TrialError& error) {
    throw ScenarioError(text(), error.what(), dynamic_cast<const PluginError*>(&error) != nullptr);
  } catch (const std::invalid_argument& error) {  // from a shape whose faces underflow
    throw ScenarioError(text(), error.what());
  }
}

/// The key that determines the mass of a rock or body.
template <class Plan>
std::string mass_key(const Plan& plan) {
  return plan.mass ? "mass" : plan.thickness ? "thickness" : "shape";
}

}  // namespace flyrock
