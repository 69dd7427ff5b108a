#pragma once
// `include: [FILE]`: materials and explosives from files beside the scenario or from flyrock's library.

#include <filesystem>
#include <map>
#include <string>

#include "document/diagnostics.h"

namespace flyrock {

/// Puts what the document names of the included files into it: a material whose name stands somewhere in the
/// document and is not among its own, and an explosive in place of its name. Removes the key `include`. A
/// file is looked up in `folder` first, then in `library`. Adds the files to `files`: name as written ->
/// path.
void include_files(Value& root, const std::filesystem::path& folder, const std::filesystem::path& library,
                   std::map<std::string, std::string>& files, Diagnostics& diagnostics);

}  // namespace flyrock
