#pragma once
// The choices of a mutation: a function of the seed, the name of what is mutated and the number of the
// mutant, on every machine the same.

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

  /// From 0 to count - 1; `count` is above 0.
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(stream_.integer(0, static_cast<std::int64_t>(count) - 1));
  }
  bool one_in(std::size_t count) { return below(count) == 0; }
  /// An element of a list that is not empty.
  template <class List>
  auto& pick(List& list) {
    return *(std::begin(list) + static_cast<std::ptrdiff_t>(below(std::size(list))));
  }

 private:
  RandomStream stream_;
};

}  // namespace flyrock::fuzz
