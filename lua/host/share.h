#pragma once
// Finds the manifests, Lua modules and report assets of the installation.

#include <string>

namespace flyrock {

/// The folder share/flyrock: FLYROCK_DATA if it is set, otherwise ../share/flyrock relative to the running
/// program.
std::string share_folder();

}  // namespace flyrock
