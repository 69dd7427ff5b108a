#pragma once
// Where the installation keeps its manifests, Lua modules and report assets.

#include <string>

namespace flyrock {

/// The folder share/flyrock: FLYROCK_DATA where that is set, else ../share/flyrock from the running program.
std::string share_folder();

}  // namespace flyrock
