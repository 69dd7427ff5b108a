#pragma once
// The names of the parts of the terrain in scenarios and laws.

#include <string>
#include <vector>

namespace flyrock {

/// `terrain.<part>` for each part; `terrain` for a part without a name.
inline std::vector<std::string> terrain_names(const std::vector<std::string>& parts) {
  std::vector<std::string> names;
  for (const std::string& part : parts) names.push_back(part.empty() ? "terrain" : "terrain." + part);
  return names;
}

}  // namespace flyrock
