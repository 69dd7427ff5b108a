#pragma once
// Runs many mutants in one child process. A signal or a hang ends only the child. Each child runs up to 1000
// mutants.
//
// The child stores the number of the current mutant in memory that it shares with its parent. If the child
// dies, uses 20 s of processor time for one mutant or sleeps as long, the parent saves that mutant and starts
// the next child after it. Processor time counts, so a busy machine causes no hangs.

#include <cstdint>
#include <filesystem>

#include "kind.h"

namespace flyrock::fuzz {

/// The outcomes of the mutants of a kind. It is in shared memory, so it holds only numbers.
struct Tally {
  std::uint64_t mutants = 0;
  std::uint64_t codes[4] = {};  ///< the most serious exit code of each mutant
  std::uint64_t signals = 0;    ///< or another sudden end
  std::uint64_t hangs = 0;
  std::uint64_t wrong =
      0;  ///< found by fault_of(): an error without a line, an exit code that is not documented
  std::uint64_t listed = 0;       ///< hangs and wrong ones of mutants that promise less (Calls::only_list)
  std::uint64_t rock_faults = 0;  ///< runs that report failed rocks: exit code 3

  std::uint64_t findings() const { return signals + hangs + wrong; }
};

struct Batch {
  const KindEntry& kind;
  std::uint64_t seed = 1;
  std::uint64_t first = 0;         ///< number of the first mutant
  std::uint64_t count = 1000;      ///< greatest number of mutants
  double seconds = 1e9;            ///< no mutant begins later; preparation does not count
  std::filesystem::path findings;  ///< folder for saved mutants
};

/// Runs the mutants of a batch and adds to `tally`. Returns the number after the last mutant tried.
std::uint64_t run_batch(const Batch& batch, Tally& tally);

/// Runs one mutant in this process, in a folder that stays, and prints what the commands print. For a
/// finding, or for a debugger.
void run_one(const KindEntry& kind, std::uint64_t seed, std::uint64_t number);

}  // namespace flyrock::fuzz
