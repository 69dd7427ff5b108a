#include "report/tables/calibration_data.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "report/page/scenario_text.h"
#include "report/tables/json_object.h"
#include "report/tables/observation_data.h"
#include "results/say/wording.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

double best_share(const FittedModel& model, std::size_t k) {
  return static_cast<double>(model.calibration.best.at[k]) / lattice;
}

/// "0.402 (90 % region 0.38 to 0.43)", in the unit of the command.
std::string value_with_region(const FittedModel& model, std::size_t k) {
  const VariedNumber& varied = model.varied[k];
  const auto number = [&](double share) {
    return three_digits(varied.low + share * (varied.high - varied.low));
  };
  const std::string unit = varied.unit.empty() ? "" : " " + varied.unit;
  const RegionRange& range = model.calibration.region[k];
  return fmt::format("{}{} (90 % region {}{} to {}{}{})", number(best_share(model, k)), unit,
                     range.is_open_below ? "from below " : "", number(range.low),
                     range.is_open_above ? "above " : "", number(range.high), unit);
}

Json parameter_data(const FittedModel& model, std::size_t k) {
  const VariedNumber& varied = model.varied[k];
  const Calibration& calibration = model.calibration;
  const WayEnd end = end_at(calibration.best.at[k]);
  const RegionRange& range = calibration.region[k];
  return json_object("path", varied.path, "value", varied.si_at(best_share(model, k)), "low",
                     varied.si_at(range.low), "high", varied.si_at(range.high), "unit", varied.si, "text",
                     varied.text_at(best_share(model, k)), "range", Json{varied.si_at(0), varied.si_at(1)},
                     "bound",
                     end == WayEnd::low    ? Json("low")
                     : end == WayEnd::high ? Json("high")
                                           : Json(nullptr),
                     "determined", range.is_determined());
}

/// Names each number that the region holds from end to end, or nearly.
std::string undetermined_text(const FittedModel& model) {
  std::string names;
  for (std::size_t k = 0; k < model.varied.size(); ++k)
    if (!model.calibration.region[k].is_determined())
      names += (names.empty() ? "" : ", ") + model.varied[k].path;
  return names.empty() ? "" : fmt::format("The measurements do not determine {}.", names);
}

std::string correlated_text(const FittedModel& model) {
  constexpr double strong = 0.9;
  std::string text;
  const auto& correlation = model.calibration.correlation;
  for (std::size_t a = 0; correlation && a < correlation->size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (std::abs((*correlation)[a][b]) > strong)
        text += fmt::format("{}{} and {} are determined together only (correlation {:.2f} over the region).",
                            text.empty() ? "" : " ", model.varied[b].path, model.varied[a].path,
                            (*correlation)[a][b]);
  return text;
}

}  // namespace

std::vector<std::string> calibration_sentences(const FittedModel& model) {
  const Calibration& calibration = model.calibration;
  std::vector<std::string> list;
  const std::string skill = model.held ? skill_text(model.skill, model.held_name) : "";
  if (model.held && !model.skill.has_skill()) list.push_back(skill);  // what matters most comes first
  for (std::size_t k = 0; k < model.varied.size(); ++k)
    list.push_back(fmt::format("{} = {}.", model.varied[k].path, value_with_region(model, k)));
  for (std::size_t k = 0; k < model.varied.size(); ++k)
    if (calibration.on_bound[k])
      list.push_back(fmt::format("{} is best at the end of its way: widen it, or doubt the model.",
                                 model.varied[k].path));
  if (!calibration.agrees)
    list.emplace_back(
        "No point agrees with what was measured: at each the energy distance is above the 90 % quantile of "
        "the model's own draws. The form of the model does not describe these measurements, and the region "
        "says only which numbers are no worse than the best.");
  for (const std::string& text : {undetermined_text(model), correlated_text(model)})
    if (!text.empty()) list.push_back(text);
  list.push_back(fmt::format("What was fitted, which is no judgement: {}",
                             observation_text(model.observed, model.fitted)));
  if (model.held && model.skill.has_skill()) list.push_back(skill);
  if (model.held)
    list.push_back(fmt::format("What was held back ({}), which judges the fit: {}", model.held_name,
                               observation_text(*model.held_plan, *model.held)));
  else
    list.emplace_back("Nothing was held back (--hold): nothing here judges the fit.");
  return list;
}

nlohmann::ordered_json calibration_data(const FittedModel& model) {
  const Calibration& calibration = model.calibration;
  Json parameters = Json::array(), correlation = nullptr;
  for (std::size_t k = 0; k < model.varied.size(); ++k) parameters.push_back(parameter_data(model, k));
  if (calibration.correlation) {
    correlation = Json::array();
    for (const std::vector<double>& row : *calibration.correlation) correlation.push_back(row);
  }
  const ObservationSummary& fitted = model.fitted;
  Json sentences = Json::array();
  for (const std::string& sentence : calibration_sentences(model)) sentences.push_back(sentence);
  return json_object(
      "flyrock", FLYROCK_ENGINE_VERSION, "scenario", model.scenario, "scenario_sha256", model.scenario_hash,
      "seed", model.seed, "trials", model.trials, "statistic", model.statistic, "evaluations",
      calibration.evaluations.size(), "answer", std::move(sentences), "parameters", std::move(parameters),
      "misfit", number(calibration.best.misfit), "energy_distance", number(fitted.energy), "energy_noise_p90",
      number(fitted.energy_noise_p90), "bias", number(fitted.bias), "bias_error", number(fitted.bias_error),
      "inside_90", number(static_cast<double>(fitted.inside) / static_cast<double>(fitted.with_band)),
      "correlation", std::move(correlation), "region_points", calibration.inside.size(), "agrees",
      calibration.agrees, "fitted", observation_data(model.observed, fitted), "held",
      model.held ? observation_data(*model.held_plan, *model.held) : Json(nullptr), "skill",
      model.held && model.skill.is_known()
          ? json_object("difference", number(model.skill.difference), "interval",
                        interval_data(model.skill.interval), "verdict", model.skill.verdict())
          : Json(nullptr),
      "held_name", model.held ? Json(model.held_name) : Json(nullptr));
}

std::string evaluations_csv(const FittedModel& model) {
  std::string text = "stage";
  for (const VariedNumber& varied : model.varied) text += "," + varied.path;
  text += ",misfit_m,energy_distance_m,energy_noise_p90_m,inside\n";
  for (const Evaluation& evaluation : model.calibration.evaluations) {
    text += evaluation.stage;
    for (std::size_t k = 0; k < model.varied.size(); ++k)
      text += "," + shortest(model.varied[k].si_at(static_cast<double>(evaluation.at[k]) / lattice));
    text += fmt::format(",{},{},{},{}\n", shortest(evaluation.misfit), shortest(evaluation.energy),
                        shortest(evaluation.noise_p90), evaluation.is_inside ? 1 : 0);
  }
  return text;
}

namespace {

/// Leaves out defaults, and names files from another folder.
void rewrite(Value& value, const std::map<std::string, std::string>& files) {
  if (Map* map = value.map()) {
    std::erase_if(*map, [](const Entry& entry) { return entry.value.assumed; });
    for (Entry& entry : *map) rewrite(entry.value, files);
  } else if (List* list = value.list()) {
    for (Value& item : *list) rewrite(item, files);
  } else if (std::string* text = std::get_if<std::string>(&value.data)) {
    if (const auto file = files.find(*text); file != files.end()) *text = file->second;
  }
}

}  // namespace

std::string fitted_scenario(const FittedModel& model, const LoadedScenario& loaded,
                            const std::filesystem::path& scenario_folder,
                            const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  const auto from_folder = [&](const fs::path& path) {
    return fs::relative(fs::absolute(path), fs::absolute(folder)).string();
  };
  std::map<std::string, std::string> files;
  for (const auto& [name, path] : loaded.plan.files)
    files[name] = fs::path(name).is_absolute() ? name : from_folder(path);
  for (const std::string& name : loaded.plan.plugin_files)
    files[name] = fs::path(name).is_absolute() ? name : from_folder(scenario_folder / name);
  Value tree = loaded.plan.resolved;
  rewrite(tree, files);
  std::string text = fmt::format(
      "# {} with {} number{} fitted by flyrock calibrate {} to {} rows of {} ({}):\n", model.scenario,
      model.varied.size(), model.varied.size() == 1 ? "" : "s", FLYROCK_ENGINE_VERSION, model.fitted.rows,
      fs::path(model.observed.file).filename().string(), name_of(model.observed.of));
  for (std::size_t k = 0; k < model.varied.size(); ++k)
    text += fmt::format("#   {}: {}\n", model.varied[k].path, value_with_region(model, k));
  text += fmt::format("# Energy distance {} m; {} trials, seed {}; scenario sha256 {}.\n",
                      three_digits(model.fitted.energy), model.trials, model.seed, model.scenario_hash);
  return text + scenario_text(tree);
}

}  // namespace flyrock
