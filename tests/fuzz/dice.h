#pragma once
// The choices of a mutation: a function of the seed, the name of the mutated input and the number of the
// mutant, the same on every machine.

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>

#include "random/stream.h"

namespace flyrock::fuzz {

class Dice {
 public:
  Dice(std::uint64_t seed, std::string_view name, std::uint64_t number)
      : stream_(seed, name, {.trial = number}) {}

  /// A number from 0 to count - 1; `count` must be above 0.
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(stream_.integer(0, static_cast<std::int64_t>(count) - 1));
  }
  bool one_in(std::size_t count) { return below(count) == 0; }
  /// An element of a list, which must not be empty.
  template <class List>
  auto& pick(List& list) {
    return *(std::begin(list) + static_cast<std::ptrdiff_t>(below(std::size(list))));
  }

 private:
  RandomStream stream_;
};

}  // namespace flyrock::fuzz
