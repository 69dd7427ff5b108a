#pragma once
// The inputs of a sensitivity analysis. An input is a stream of random numbers, or several at once: a draw is
// a function of seed, stream name and place, so "all but this input" is the same run with its streams from
// another seed (random/stream.h).

#include <string>
#include <vector>

#include "scenario/plan.h"

namespace flyrock {

inline constexpr const char* everything_else = "everything else";

struct ExchangedInput {
  std::string name;                  ///< of its only stream, of a group, or `everything_else`
  std::vector<std::string> streams;  ///< of `everything_else`: none, it has all that the others have not
};

/// A stream that is drawn and is no input, and why.
struct NoInput {
  std::string stream, why;
};

struct InputChoice {
  std::vector<std::string> inputs;                                       ///< --inputs; empty: as default
  std::vector<std::pair<std::string, std::vector<std::string>>> groups;  ///< --group
};

struct ExchangedInputs {
  std::vector<ExchangedInput> inputs;   ///< the last one is `everything_else`
  std::vector<std::string> once_a_run;  ///< drawn once a run: no inputs
  std::vector<NoInput> not_read;        ///< nothing of the run reads them; among `everything_else`
};

/// Every stream that a scenario may draw from anew in each trial: draws from distributions, of branches too,
/// and those of plugins, releases, orientations and branches.
std::vector<std::string> streams_of(const Scenario& scenario);

/// The inputs of a scenario. By default each draw that something reads, a population that is not
/// `independent`, the place of a random release, a random orientation of a rock that is no point, the
/// branches; then everything else. A name stands for its stream and
/// all streams below it ("rocks.face") that are not named apart.
/// Throws std::invalid_argument for a name without a stream, or a stream in two inputs.
ExchangedInputs exchanged_inputs(const Plan& plan, const InputChoice& choice);

/// What is drawn from the seed of the second base: nothing, all inputs, then one input at a time.
std::vector<Exchange> exchanges(const ExchangedInputs& inputs, std::uint64_t seed);

/// Lets a scenario and its branches ask the table at `exchange`, which must outlive it.
void ask_for_exchanges(Scenario& scenario, const Exchange* exchange);

}  // namespace flyrock
