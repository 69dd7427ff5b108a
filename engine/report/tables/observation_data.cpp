#include "report/tables/observation_data.h"

#include <nlohmann/json.hpp>

#include "report/page/rounded.h"
#include "report/tables/json_object.h"

namespace flyrock {

namespace {

nlohmann::ordered_json quantiles_data(const ObservationSummary& summary) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const double level : compared_levels)
    list.push_back(json_object("level", level, "observed", number(summary.observed.quantile(level)), "model",
                               number(summary.model.quantile(level))));
  return list;
}

nlohmann::ordered_json rocks_data(const ObservationSummary& summary) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  const auto text = [](const std::string& name) {
    return name.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(name);
  };
  for (const ObservedRock& rock : summary.rocks)
    list.push_back(json_object(
        "name", text(rock.name), "group", text(rock.group), "observed", number(rock.observed), "p5",
        number(rock.p5), "p50", number(rock.p50), "p95", number(rock.p95), "inside",
        std::isnan(rock.p5) ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(rock.is_inside),
        "trials", rock.trials, "censored", rock.censored));
  return list;
}

nlohmann::ordered_json measured_data(const SortedSample& measured) {
  const bool none = measured.empty();
  return json_object("min", number(none ? unknown : measured.quantile(0)), "p50",
                     number(none ? unknown : measured.quantile(0.5)), "max",
                     number(none ? unknown : measured.quantile(1)));
}

nlohmann::ordered_json throws_data(const ThrowSummary& throws) {
  nlohmann::ordered_json factors = nlohmann::ordered_json::array(), site = nullptr;
  for (const CoveringFactor& factor : throws.factors)
    factors.push_back(json_object("covers", factor.covers, "factor", number(factor.factor), "interval",
                                  interval_data(factor.interval)));
  if (throws.site)
    site = json_object("factor", number(throws.site->factor), "fitted", throws.site->fitted, "covered",
                       number(throws.site->covered.value), "interval",
                       interval_data(throws.site->covered.interval), "judged", throws.site->judged);
  return json_object("blasts", throws.blasts, "short", number(throws.short_of.value), "short_interval",
                     interval_data(throws.short_of.interval), "factors", std::move(factors),
                     "rank_correlation", number(throws.rank.r), "rank_interval",
                     interval_data(throws.rank_interval), "site", std::move(site));
}

}  // namespace

nlohmann::ordered_json observation_data(const ObservedPlan& plan, const ObservationSummary& summary) {
  constexpr int drawn = 101;
  nlohmann::ordered_json levels = nlohmann::ordered_json::array(), model = nlohmann::ordered_json::array();
  for (int i = 0; i < drawn && !summary.model.empty(); ++i) {
    const double level = i / (drawn - 1.0);
    levels.push_back(level);
    model.push_back(rounded(summary.model.quantile(level)));
  }
  nlohmann::ordered_json data = json_object(
      "of", name_of(plan.of), "per", name_of(plan.per), "rows", summary.rows, "measured",
      measured_data(summary.observed), "values", summary.values, "censored", summary.censored, "lost",
      summary.lost, "paired", summary.is_paired, "scatter", summary.has_scatter, "bias", number(summary.bias),
      "bias_error", number(summary.bias_error), "across", number(summary.across), "across_error",
      number(summary.across_error), "energy_distance", number(summary.energy), "with_censored",
      json_object("bias", number(summary.with_censored.bias), "bias_error",
                  number(summary.with_censored.bias_error), "energy_distance",
                  number(summary.with_censored.energy)),
      "energy_noise", number(summary.energy_noise), "energy_noise_p90", number(summary.energy_noise_p90),
      "inside_90",
      json_object("rows", summary.inside, "of", summary.with_band, "share",
                  number(static_cast<double>(summary.inside) / static_cast<double>(summary.with_band)),
                  "interval", interval_data(summary.inside_interval)),
      "constant",
      json_object("value", number(summary.constant), "energy_distance", number(summary.constant_energy)),
      "quantiles", quantiles_data(summary), "rocks", rocks_data(summary), "levels", std::move(levels),
      "model", std::move(model));
  if (summary.throws) data["throws"] = throws_data(*summary.throws);
  return data;
}

}  // namespace flyrock
