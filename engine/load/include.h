#pragma once
// `include: [FILE]`: materials and explosives from files beside the scenario or from flyrock's library.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "document/diagnostics.h"
#include "document/value.h"

namespace flyrock {

/// Reads the files that the document includes, and removes its key `include`. A file is looked up in `folder`
/// first, then in `library`. Adds the files to `files`: name as written -> path.
std::vector<Value> included_files(Value& root, const std::filesystem::path& folder,
                                  const std::filesystem::path& library,
                                  std::map<std::string, std::string>& files, Diagnostics& diagnostics);

/// Puts what the document names of included files into it: a material whose name stands somewhere in the
/// document and is not among its own, and an explosive in place of its name.
void take_included(Value& root, const std::vector<Value>& files, Diagnostics& diagnostics);

}  // namespace flyrock
