#pragma once
// All kinds of mutants in turn, and the table of what became of them.

#include <string>
#include <vector>

#include "batch.h"

namespace flyrock::fuzz {

struct FuzzSettings {
  std::uint64_t seed = 1;
  double seconds = 60;        ///< shared out among the kinds; without bound where `mutants` is given
  std::uint64_t mutants = 0;  ///< in all, shared out likewise; 0: as many as the time allows
  std::string kind;           ///< only this one
  std::filesystem::path findings = "out/fuzz";
};

struct KindTally {
  std::string kind;
  Tally tally;
};

/// The same seed gives the same mutants in the same order; the time says how many.
std::vector<KindTally> fuzz(const FuzzSettings& settings);

/// A row a kind and one of their sums.
std::string table_of(const std::vector<KindTally>& tallies);

Tally sum_of(const std::vector<KindTally>& tallies);

}  // namespace flyrock::fuzz
