#include "host/share.h"

#include <cstdlib>
#include <filesystem>

namespace flyrock {

std::string share_folder() {
  if (const char* data = std::getenv("FLYROCK_DATA"); data && *data) return data;
  const auto program = std::filesystem::read_symlink("/proc/self/exe");
  return (program.parent_path().parent_path() / "share" / "flyrock").string();
}

}  // namespace flyrock
