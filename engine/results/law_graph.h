#pragma once
// The graph of a contact law, computed from solved contacts.

#include <string>
#include <vector>

#include "plugin/registry.h"
#include "solver/contact_problem.h"

namespace flyrock {

/// One quantity against another, for one or more cases.
struct LawGraph {
  std::string title, x, y;
  struct Case {
    std::string name;
    std::vector<double> at, value;
  };
  std::vector<Case> cases;
};

/// The graphs of a law with constant parameters. Each point is one solved contact of a solid ball of 500 kg
/// and 0.3 m (W_nn = 1/m, W_tt = 3.5/m) that had no contact before:
///   - restitution: the share of the normal and of the tangential speed that remains after an impact, by
///     speed and by angle, with mu = 0.5;
///   - friction: r_t / r_n against the slip that remains; the ball's weight presses the contact over 1 ms.
///     For a law with memory also along a slide at 1 m/s;
///   - rolling: m_r / r_n against the rolling velocity that remains;
///   - unilateral: the force r_n / h against the normal velocity that remains, and against the gap. A spring
///     shows its force directly; for the others the load goes from ten times the ball's weight to an equally
///     strong pull.
/// Throws PluginError, also for a plugin that is not a contact law.
std::vector<LawGraph> law_graphs(const PluginUse& use);

}  // namespace flyrock
