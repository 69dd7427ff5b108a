#pragma once
// Opens shared objects, whose files may be cut.

#include <string>

namespace flyrock {

/// The handle of the shared object `path` (dlopen, RTLD_NOW | RTLD_LOCAL); null, and the reason in `fault`,
/// if it cannot be opened or has a shared_object_fault.
void* open_shared_object(const std::string& path, std::string& fault);

/// What the headers of the file show to be wrong with it: it is no shared object, was built for another
/// processor, or does not contain all of its segments and sections. Empty if nothing is. The loader maps each
/// segment as the headers say, and a page beyond the end of the file ends the process (SIGBUS) when it is
/// first used. Source: System V Application Binary Interface, chapters 4 (object files) and 5 (loading).
std::string shared_object_fault(const std::string& path);

}  // namespace flyrock
