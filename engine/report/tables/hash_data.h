#pragma once
// The hashes of the inputs of a run, for the manifest and the report.

#include <nlohmann/json.hpp>
#include <vector>

#include "load/load.h"

namespace flyrock {

/// [{ name, sha256 }], in the order of `hashes`.
inline nlohmann::ordered_json hash_data(const std::vector<SourceHash>& hashes) {
  auto data = nlohmann::ordered_json::array();
  for (const SourceHash& hash : hashes) data.push_back({{"name", hash.name}, {"sha256", hash.sha256}});
  return data;
}

}  // namespace flyrock
