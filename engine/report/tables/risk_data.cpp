#include "report/tables/risk_data.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "report/tables/json_object.h"
#include "scenario/derived_inputs.h"

namespace flyrock {

namespace {

nlohmann::ordered_json measured_data(const BlastPlan& plan) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  const std::vector<DerivedNumbers> derived = typical_of_holes(plan);
  for (std::size_t i = 0; i < plan.holes.size(); ++i) {
    const Hole& hole = plan.pattern.measured[i];
    const Blast& blast = plan.holes[i];
    const BlastDesign& design = plan.hole_designs[i];
    list.push_back(json_object(
        "hole", hole.name, "row", hole.row, "x", number(hole.x), "y", number(hole.y), "z", number(hole.z),
        "time_s", hole.time, "burden_m", number(blast[BlastField::burden]), "stemming_m",
        number(blast[BlastField::hole_stemming]), "charge_kg", number(design.charge_per_hole),
        "charge_kg_per_m", number(design.linear_charge), "charge_to_mass", number(design.charge_to_mass),
        "rock_m3", number(design.rock), "powder_factor_kg_m3", number(design.powder_factor)));
    for (std::size_t d = 0; d < derived_count; ++d)
      list.back()["derived"][derived_infos()[d].name] = number(derived[i][d]);
  }
  return list;
}

nlohmann::ordered_json risk_data(const BlastPlan& plan, const Risk& risk) {
  std::vector<std::size_t> order(risk.of_hole.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return risk.of_hole[a] > risk.of_hole[b]; });
  nlohmann::ordered_json holes = nlohmann::ordered_json::array();
  for (const std::size_t i : order)
    if (const std::uint64_t rocks = risk.of_hole[i]; rocks > 0)
      holes.push_back(json_object("hole", plan.pattern.measured[i].name, "rocks", rocks, "share",
                                  static_cast<double>(rocks) / static_cast<double>(risk.rocks)));
  return json_object("of", risk.of, "distance_m", number(risk.distance), "rocks", risk.rocks, "holes", holes);
}

/// Burdens to the millimetre.
nlohmann::ordered_json face_data(const BlastPlan& plan) {
  const auto millimetres = [](const std::vector<double>& values) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const double value : values) list.push_back(number(std::round(1000 * value) / 1000));
    return list;
  };
  nlohmann::ordered_json burdens = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < plan.face->curves.size(); ++i) {
    const BurdenCurve& curve = plan.face->curves[i];
    if (curve.depth.empty()) continue;
    nlohmann::ordered_json known = nlohmann::ordered_json::array();
    for (const bool is_known : curve.is_known) known.push_back(is_known);
    burdens.push_back(json_object("hole", plan.pattern.measured[i].name, "charge_m",
                                  nlohmann::ordered_json{curve.charge_from, curve.charge_to}, "depth_m",
                                  millimetres(curve.depth), "burden_m", millimetres(curve.burden), "known",
                                  known));
  }
  return json_object("noise_m", number(plan.face->noise), "error_m", number(plan.face->error), "burdens",
                     burdens);
}

nlohmann::ordered_json quantile_of(const Bounded& bounded) { return number(bounded.value); }

}  // namespace

nlohmann::ordered_json branches_data(const Scenario& scenario, const RiskSummary& summary) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  const std::vector<std::string> names = branch_names(scenario);
  for (std::size_t b = 0; b < summary.branches.size(); ++b) {
    const BranchSummary& branch = summary.branches[b];
    nlohmann::ordered_json risks = nlohmann::ordered_json::array();
    for (const Risk& risk : summary.risks) {
      const auto units = static_cast<double>(branch.units),
                 with = static_cast<double>(risk.units_of_branch[b]);
      risks.push_back(json_object("of", risk.of, "distance_m", number(risk.distance), "rocks",
                                  risk.of_branch[b], "units", risk.units_of_branch[b], "share",
                                  number(with / units), "interval",
                                  interval_data(share_interval(with, units, stated_confidence))));
    }
    list.push_back(json_object("branch", names[b], "per", branch.per_blast ? "blast" : "hole", "probability",
                               branch.probability, "units", branch.units, "share", number(branch.share.value),
                               "interval", interval_data(branch.share.interval), "rocks", branch.rocks,
                               "runout",
                               json_object("p50", quantile_of(branch.p50), "p95", quantile_of(branch.p95),
                                           "p99", quantile_of(branch.p99), "max", quantile_of(branch.max)),
                               "risk", risks));
  }
  return list;
}

void add_hole_data(nlohmann::ordered_json& data, const BlastPlan& plan, const std::vector<Risk>& risks) {
  if (!plan.has_holes()) return;
  data["measured"] = measured_data(plan);
  nlohmann::ordered_json& list = data["risk"] = nlohmann::ordered_json::array();
  for (const Risk& risk : risks) list.push_back(risk_data(plan, risk));
  if (plan.face) data["face"] = face_data(plan);
}

}  // namespace flyrock
