#pragma once
// Graphs of the laws that a run used, sampled from the laws themselves.

#include <string>
#include <vector>

#include "scenario/scenario.h"

namespace flyrock {

/// The rock that meets the law in a graph.
struct LawSubject {
  double mass = 0;    ///< kg
  double radius = 0;  ///< m
};

/// One answer of a law against a speed. Where its parameters are drawn, `low` and `high` hold nine tenths of
/// 50 draws and `middle` is their median; else all three are the same. A curve ends where its law fails.
struct MaterialCurve {
  std::string name;  ///< "e_n, impact at 90 deg"
  std::vector<double> low = {}, middle = {}, high = {};
};

struct MaterialGraph {
  std::string material = {}, kind = {}, law = {};  ///< "haul_floor", "restitution", "pfeiffer_bowen"
  std::string doc = {}, source = {};               ///< of its manifest
  std::string x = {}, y = {};                      ///< what the axes show: "approach speed in m/s", "e_n"
  std::vector<double> speed = {};                  ///< m/s, 0.1 to 50 by equal ratios
  std::vector<MaterialCurve> curves = {};
  bool drawn = false;      ///< its parameters are
  std::string fault = {};  ///< what the law said where it failed, or empty
};

/// Restitution at impacts of 90 and 30 degrees from the surface, static and dynamic friction against the
/// speed of slip, and the bound of the rolling torque over the normal force against the speed of rolling, of
/// every material that has such a law. Contacts are first ones of their rock, at time 0. The laws are made
/// anew: call it in the thread of the scenario's session.
std::vector<MaterialGraph> material_graphs(const Scenario& scenario, const LawSubject& subject);

}  // namespace flyrock
