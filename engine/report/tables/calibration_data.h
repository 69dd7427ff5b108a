#pragma once
// calibration.json, evaluations.csv and fitted.yaml: what `flyrock calibrate` found.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "load/load.h"
#include "results/compare/calibration.h"
#include "results/compare/observation.h"
#include "results/compare/skill.h"
#include "results/compare/varied_number.h"

namespace flyrock {

/// A calibration with what belongs to it.
struct FittedModel {
  std::vector<VariedNumber> varied;
  std::string statistic;  ///< "energy" or "quantiles"
  Calibration calibration;
  std::string scenario;  ///< its file name
  std::string scenario_hash;
  ObservedPlan observed;
  ObservationSummary fitted;  ///< of the rows of the fit, at the best point
  std::uint64_t trials = 0, seed = 0;
  std::string held_name;  ///< the label or file of what was held back; empty: nothing
  std::optional<ObservedPlan> held_plan;
  std::optional<ObservationSummary> held;  ///< of what was held back, at the best point
  Skill skill;                             ///< of what was held back
};

/// docs/results.md has its fields. Numbers in SI units.
nlohmann::ordered_json calibration_data(const FittedModel& model);

/// Each evaluated point, in order: stage, numbers (SI), misfit, energy distance, 90 % of its noise, inside.
std::string evaluations_csv(const FittedModel& model);

/// The scenario with the fitted numbers, and where they come from in comments. `folder`: where it will be;
/// `loaded`: the scenario at the best point.
std::string fitted_scenario(const FittedModel& model, const LoadedScenario& loaded,
                            const std::filesystem::path& scenario_folder,
                            const std::filesystem::path& folder);

/// The result in sentences: the numbers with their regions, what they do not say, and the judgement on what
/// was held back.
std::vector<std::string> calibration_sentences(const FittedModel& model);

}  // namespace flyrock
