#pragma once
// The graph of a contact law, computed from solved contacts.

#include <optional>
#include <string>
#include <vector>

#include "plugin/registry.h"
#include "solver/contact_problem.h"
#include "units/units.h"

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

/// The solid ball whose contact is plotted (W_nn = 1/m, W_tt = 3.5/m), and the range of the plot.
struct LawBall {
  double mass = 500;                ///< kg
  double radius = 0.3;              ///< m
  double mu = 0.5;                  ///< coefficient of friction at the impacts of a restitution law
  std::optional<Quantity> to = {};  ///< end of the axis of the first graph; empty: chosen from the law
};

/// The graphs of a law with constant parameters. Each point is one solved contact of the ball, which had no
/// contact before:
///   - restitution: the share of the normal and of the tangential speed that remains after an impact, by
///     speed (to 30 m/s) and by angle at a third of the greatest speed. For a law that changes from one
///     impact of the ball to the next, by its memory or by their number, also impact by impact, at 45 degrees
///     and that speed;
///   - friction: r_t / r_n against the slip that remains, up to where the law no longer changes; the ball's
///     weight presses the contact over 1 ms. For a law with memory also along a slide at 1 m/s;
///   - rolling: m_r / r_n against the rolling velocity that remains (to 5 rad/s);
///   - unilateral: the force r_n / h against the normal velocity that remains (to 2 m/s), and against the gap
///     that is left: the load goes from ten times the ball's weight to an equally strong pull. A spring shows
///     its force against the overlap, up to ten times the weight, with a damper also at the speeds at which
///     the ball would come and go, and a tangential spring against its stretch.
/// Throws PluginError, also for a plugin that is not a contact law and for a `to` in another unit.
std::vector<LawGraph> law_graphs(const PluginUse& use, const LawBall& ball = {});

}  // namespace flyrock
