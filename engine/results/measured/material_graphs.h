#pragma once
// Graphs of the laws that a run used, sampled from the laws themselves.

#include <string>
#include <vector>

#include "results/measured/sampled_law.h"
#include "scenario/scenario.h"

namespace flyrock {

/// One answer of a law against a speed. If its parameters are drawn, `low` and `high` enclose nine tenths of
/// 50 draws and `middle` is their median; otherwise all three are the same. A curve ends where its law fails.
struct MaterialCurve {
  std::string name;  ///< "e_n, impact at 90 deg"
  std::vector<double> low = {}, middle = {}, high = {};
};

struct MaterialGraph {
  std::string material = {}, kind = {}, law = {};  ///< "haul_floor", "restitution", "pfeiffer_bowen"
  std::string doc = {}, source = {};               ///< from its manifest
  std::string x = {}, y = {};                      ///< labels of the axes: "approach speed in m/s", "e_n"
  std::vector<double> speed = {};                  ///< m/s, 0.1 to 50 in equal ratios
  std::vector<MaterialCurve> curves = {};
  bool drawn = false;      ///< its parameters are drawn
  std::string fault = {};  ///< error of the law; empty if it did not fail
};

/// For every material with such a law: restitution at impacts of 90 and 30 degrees from the surface, static
/// and dynamic friction against the slip speed, and the bound of the rolling torque divided by the normal
/// force against the rolling speed. Each contact is the first of its rock, at time 0. The laws are made
/// again, so call this in the thread of the scenario's session.
std::vector<MaterialGraph> material_graphs(const Scenario& scenario, const LawSubject& subject);

}  // namespace flyrock
