#pragma once
// What `flyrock new` can copy: scenarios, labs and templates of plugins.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace flyrock::cli {

/// By name, sorted: quarry/fence_design, course/cradle, restitution, restitution-native.
std::vector<std::pair<std::string, std::filesystem::path>> offers();

}  // namespace flyrock::cli
