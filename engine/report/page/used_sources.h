#pragma once
// The plugins that a run used, of all that were loaded.

#include <vector>

#include "load/load.h"

namespace flyrock {

/// The sources of `loaded` without the manifests of those plugins of flyrock that are no `type` of the
/// resolved scenario.
std::vector<SourceHash> used_sources(const LoadedScenario& loaded);

}  // namespace flyrock
