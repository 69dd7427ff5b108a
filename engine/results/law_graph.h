#pragma once
// The graph of a contact law, from solved contacts.

#include <string>
#include <vector>

#include "plugin/registry.h"
#include "solver/contact_problem.h"

namespace flyrock {

/// What a graph shows: one quantity against another, for one or more cases.
struct LawGraph {
  std::string title, x, y;
  struct Case {
    std::string name;
    std::vector<double> at, value;
  };
  std::vector<Case> cases;
};

/// The graphs of a law with constant parameters, each point one solved contact of a solid ball of 500 kg and
/// 0.3 m (W_nn = 1/m, W_tt = 3.5/m) that has met nothing before:
///  - restitution: the share of normal and tangential speed that an impact leaves, by speed and by angle,
///  with mu = 0.5;
///  - friction: r_t / r_n against the slip that is left, the contact pressed by the ball's weight over 1 ms;
///  for a law
///    that remembers also along a slide at 1 m/s;
///  - rolling: m_r / r_n against the rolling velocity that is left;
///  - unilateral: the force r_n / h against the normal velocity that is left, and against the gap: of a
///  spring as it is, of the
///    others as a load from ten times the ball's weight to as strong a pull leaves it.
/// Throws PluginError, also for a plugin that is no contact law.
std::vector<LawGraph> law_graphs(const PluginUse& use);

}  // namespace flyrock
