#pragma once
// Warns if a launch model was fitted to distances (Launch::greatest_throw), and drag or the launch angle of
// the scenario make its rocks land short of them.

#include "document/node.h"
#include "scenario/scenario.h"

namespace flyrock {

struct Plan;
struct Value;

/// Richards-Moore, McKenzie and Lundborg fitted the greatest throw observed in air, at 45 degrees (ejected
/// stemming: along the hole). Their launch speed reaches this distance without air, at this angle. With drag,
/// or at another angle, all rocks land short of it, because the effect of the air is then counted twice.
///
/// Warns at `rocks.N.launch` of the group that lands shortest relative to its formula, and names the others.
/// Flies the rocks of the first trials over level ground. A landing within 1 % of the formula gives no
/// warning.
void warn_of_short_throws(const Value& root, const Plan& plan, Diagnostics& diagnostics);

/// "richards_moore (cratering, k 27)": the model with its choices and dimensionless numbers.
std::string model_text(const PluginUse& use);

}  // namespace flyrock
