#pragma once
// Opens shared objects with native plugins.

#include <string>

#include "plugin/registry.h"

namespace flyrock {

/// Opens `path` (RTLD_NOW | RTLD_LOCAL, never closed), compares its tag with the engine's and adds its
/// factories to `table`. Returns an error text that names the file, or an empty one.
std::string load_module(const std::string& path, FactoryTable& table);

/// The same for a file of unknown origin. A child process opens it first, because the loader may crash on
/// damaged bytes. Damage to the code of a law is not seen.
std::string load_module_guarded(const std::string& path, FactoryTable& table);

}  // namespace flyrock
