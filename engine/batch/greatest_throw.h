#pragma once
// Launch models that were fitted to distances (Launch::greatest_throw), and what it changes to fly them
// otherwise.

#include "document/node.h"
#include "scenario/scenario.h"

namespace flyrock {

/// Richards-Moore, McKenzie and Lundborg fitted the greatest throw that was seen, in air, at 45 degrees
/// (ejected stemming: along the hole). Their launch speed reaches that distance without air, at that angle.
/// With drag, or at another angle, all rocks land short of it: the air counts twice.
///
/// Warns at `rocks.N.launch` of the group that lands shortest against its formula, and names the others. It
/// flies the rocks of the first trials over level ground; what lands within 1 % of the formula is no news.
void warn_of_short_throws(const Value& root, const Plan& plan, Diagnostics& diagnostics);

/// "richards_moore (cratering, k 27)": the model with its choices and pure numbers.
std::string model_text(const PluginUse& use);

}  // namespace flyrock
