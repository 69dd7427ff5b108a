#pragma once
// Many mutants in one child process: a signal or a hang costs the child, not the program, and the child is
// started once for up to 1000 mutants.
//
// The child notes the number of the mutant under way in memory that it shares with its parent. Where it dies,
// or uses 20 s of the processor for one mutant or sleeps as long, that mutant is saved and the next child
// goes on behind it. A busy machine thus makes no hangs.

#include <cstdint>
#include <filesystem>

#include "kind.h"

namespace flyrock::fuzz {

/// What became of the mutants of a kind. It lives in shared memory: numbers only.
struct Tally {
  std::uint64_t mutants = 0;
  std::uint64_t codes[4] = {};  ///< the gravest exit code of each mutant
  std::uint64_t signals = 0;    ///< or another sudden end
  std::uint64_t hangs = 0;
  std::uint64_t wrong =
      0;  ///< what fault_of() finds: an error without a line, an exit code that is not documented
  std::uint64_t rock_faults = 0;  ///< runs that say which rocks failed: exit code 3

  std::uint64_t findings() const { return signals + hangs + wrong; }
};

struct Batch {
  const KindEntry& kind;
  std::uint64_t seed = 1;
  std::uint64_t first = 0;         ///< number of the first mutant
  std::uint64_t count = 1000;      ///< of mutants, at most
  double seconds = 1e9;            ///< after which no other mutant begins; getting ready is not counted
  std::filesystem::path findings;  ///< folder of saved mutants
};

/// Runs the mutants of a batch and adds to `tally`; the number behind the last one that was tried.
std::uint64_t run_batch(const Batch& batch, Tally& tally);

/// One mutant in this process, in a folder that stays: prints what the commands print. For a finding, or for
/// a debugger.
void run_one(const KindEntry& kind, std::uint64_t seed, std::uint64_t number);

}  // namespace flyrock::fuzz
