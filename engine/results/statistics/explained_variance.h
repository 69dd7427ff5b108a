#pragma once
// What `flyrock sensitivity` found: of each number of a trial the inputs that explain its variance, and how
// it moves with them; and the sentences that say so.

#include <string>
#include <utility>
#include <vector>

#include "batch/exchanged_inputs.h"
#include "results/measured/trial_measure.h"
#include "results/statistics/input_response.h"
#include "results/statistics/sobol.h"

namespace flyrock {

/// How a number moves with an input, or with a number of the blast that is made of inputs.
struct NamedResponse {
  std::string path, unit;  ///< unit: SI
  InputResponse response;
  std::optional<LineCrossing> crossing;  ///< where a line is asked for
};

/// The mean over the two inputs with the greatest total indices.
struct NamedMap {
  std::string x, y, x_unit, y_unit;
  ResponseMap map;
};

/// One number of a trial.
struct ExplainedNumber {
  std::string of, words, unit;                          ///< `of`: as `--of`; unit: SI
  SobolIndices indices;                                 ///< in the order of ExchangedInputs::inputs
  std::vector<std::optional<NamedResponse>> responses;  ///< of each input; nothing without one number a trial
  std::vector<NamedResponse> made;                      ///< of derived numbers of the blast
  std::vector<std::vector<std::string>> made_of;        ///< of each of them the paths
  std::optional<NamedMap> map;                          ///< nothing where fewer than two inputs move it
};

struct ExplainedVariance {
  std::string scenario, title, hash;
  std::uint64_t seed = 1, trials = 0;
  ExchangedInputs inputs;
  std::vector<ExplainedNumber> numbers;
  std::optional<double> line;              ///< that the curves are asked to cross
  std::vector<std::string> moves_later;    ///< groups whose number of rocks differs from trial to trial
  std::vector<std::string> not_of_launch;  ///< inputs that no launch model reads, though the run does

  std::uint64_t evaluations() const { return trials * (inputs.inputs.size() + 2); }
};

/// The inputs in the order of their total index, greatest first.
std::vector<std::size_t> ranked(const SobolIndices& indices);

/// "2.7 m", "70 deg": a number in the unit that people read.
std::string shown_number(double value, const std::string& si);
/// "61 %", of variances: whole percent.
std::string whole_percent(double share);
/// "97 % (89 to 100 %)", cut off at 0 and 1.
std::string part_text(double share, const Interval& interval);

/// The answer for one number: what explains it, what acts together, what moves nothing, and by how much the
/// first inputs move it.
std::vector<std::string> sentences_of(const ExplainedVariance& found, const ExplainedNumber& number);

/// What holds for all numbers: what nothing reads, what is drawn once a run, what moves later draws.
std::vector<std::string> remarks_of(const ExplainedVariance& found);

/// Inputs that the run reads and no launch model does: the angle of the face, which only shapes the ground.
std::vector<std::string> inputs_not_of_launch(const Scenario& scenario);

}  // namespace flyrock
