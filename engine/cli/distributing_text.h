#pragma once
// An impact by the law of Liu, Zhao and Brogliato, as a person reads it and as JSON.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "batch/explain.h"
#include "solver/distributing.h"

namespace flyrock::cli {

/// The path of the contacts of an island.
struct DistributedIsland {
  std::vector<int> contacts;  ///< of the explanation
  double exponent = 1.5;      ///< of their springs, which are equally stiff
  std::vector<DistributingPoint> path;
};

/// An explained impact with springs of this exponent in place of its laws; their coefficients of restitution
/// e_n are energetic. Throws InputError for a step, for friction, and for e_n = 0.
std::vector<DistributedIsland> distribute(const Explanation& explanation, double exponent);

std::string text_of(const Explanation& explanation, const std::vector<DistributedIsland>& islands);
nlohmann::ordered_json json_of(const std::vector<DistributedIsland>& islands);

}  // namespace flyrock::cli
