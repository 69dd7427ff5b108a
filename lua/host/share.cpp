#include "host/share.h"

#include <cstdlib>
#include <filesystem>

namespace flyrock {

namespace {

/// The folder `share` of the installation, or of a build tree, which has the same folders. The archive for
/// older systems runs lib/ld-linux-x86-64.so.2, which is as deep as bin/flyrock.
std::filesystem::path prefix() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path();
}

}  // namespace

std::string share_folder() {
  if (const char* data = std::getenv("FLYROCK_DATA"); data && *data) return data;
  return (prefix() / "share" / "flyrock").string();
}

std::string module_folder() { return (prefix() / "lib" / "flyrock").string(); }

std::string program_file() { return (prefix() / "bin" / "flyrock").string(); }

}  // namespace flyrock
