#pragma once
// The explanation of a contact problem as a person reads it, and as JSON.

#include <nlohmann/json.hpp>
#include <string>

#include "batch/explain.h"

namespace flyrock::cli {

/// `title`: "impact 3 of trial 0 of cradle.yaml".
std::string text_of(const Explanation& explanation, const std::string& title);

/// All sweeps and all numbers with full precision; matrices as lists of rows, vectors contact by contact.
nlohmann::ordered_json json_of(const Explanation& explanation);

/// The numbers of a vector.
nlohmann::ordered_json list_of(const Eigen::VectorXd& values);

}  // namespace flyrock::cli
