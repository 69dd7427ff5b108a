#pragma once
// Runs all kinds of mutants in turn and makes the table of outcomes.

#include <string>
#include <vector>

#include "batch.h"

namespace flyrock::fuzz {

struct FuzzSettings {
  std::uint64_t seed = 1;
  double seconds = 60;        ///< divided among the kinds; no limit if `mutants` is given
  std::uint64_t mutants = 0;  ///< total, divided in the same way; 0: as many as the time allows
  std::string kind;           ///< only this one
  std::filesystem::path findings = "out/fuzz";
};

struct KindTally {
  std::string kind;
  Tally tally;
};

/// The same seed gives the same mutants in the same order. The time only limits how many run.
std::vector<KindTally> fuzz(const FuzzSettings& settings);

/// One row for each kind and one for their sums.
std::string table_of(const std::vector<KindTally>& tallies);

Tally sum_of(const std::vector<KindTally>& tallies);

}  // namespace flyrock::fuzz
