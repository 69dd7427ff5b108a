#include "cli/offers.h"

#include <algorithm>

#include "host/share.h"

namespace flyrock::cli {

namespace fs = std::filesystem;

std::vector<std::pair<std::string, fs::path>> offers() {
  std::vector<std::pair<std::string, fs::path>> list;
  const fs::path share = share_folder();
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(share / "scenarios")) {
    const fs::path& file = entry.path();
    if (!entry.is_regular_file() || (file.extension() != ".yaml" && file.extension() != ".lua")) continue;
    const fs::path name = fs::relative(file, share / "scenarios");
    // If two scenarios have one name, the one in Lua keeps its ending.
    const bool second = file.extension() == ".lua" && fs::exists(fs::path(file).replace_extension(".yaml"));
    list.emplace_back((name.parent_path() / (second ? name.filename() : name.stem())).string(), file);
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(share / "templates"))
    list.emplace_back(entry.path().stem().string(), entry.path());
  std::sort(list.begin(), list.end());
  return list;
}

}  // namespace flyrock::cli
