#pragma once
// Finds the manifests, Lua modules, report assets and native plugins of the installation.

#include <string>

namespace flyrock {

/// The folder share/flyrock: FLYROCK_DATA if it is set, otherwise ../share/flyrock relative to the running
/// program.
std::string share_folder();

/// The folder of the native plugins, ../lib/flyrock relative to the running program: they belong to its
/// build.
std::string module_folder();

/// The file that starts flyrock, for scripts: ../bin/flyrock relative to the running program. In the archive
/// for older systems the running program is the loader in lib, and bin/flyrock the script that calls it.
std::string program_file();

}  // namespace flyrock
