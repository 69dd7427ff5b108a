#pragma once
// How distributions are written: `uniform: [low, high]` is a list, `normal: { mean, sd }` a map.

#include <string>
#include <vector>

namespace flyrock {

/// A number of a distribution. It has the dimension of the drawn quantity, or none.
struct DistributionNumber {
  std::string name;
  bool has_dimension = true;
};

/// `discrete` and `sieve` have lists in place of numbers: `numbers` is empty.
struct DistributionForm {
  std::string name;
  bool is_list = false;
  std::vector<DistributionNumber> numbers;
};

/// All forms, in the order of the documentation.
std::vector<DistributionForm> distribution_forms();

}  // namespace flyrock
