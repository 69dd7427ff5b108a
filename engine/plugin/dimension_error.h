#pragma once
// How a plugin refuses a dimension.

#include "plugin/params.h"

namespace flyrock {

/// The plugin does not serve the dimension of the scenario, or its answer is one of the other dimension.
struct DimensionError : ParameterError {
  using ParameterError::ParameterError;
};

}  // namespace flyrock
