#pragma once
// The JSON Schema (draft-07) of a scenario, from the sections of the schema and the manifests of the plugins.
//
// A section with a `type` is one of a branch for each plugin that flyrock brings and a last branch, which
// takes any parameters: for the types of a user's own plugins.

#include <nlohmann/json.hpp>

#include "plugin/registry.h"

namespace flyrock::cli {

nlohmann::ordered_json scenario_schema(const Registry& registry);

}  // namespace flyrock::cli
