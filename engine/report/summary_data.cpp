#include "report/summary_data.h"

#include <algorithm>
#include <cmath>

#include "report/azimuth_data.h"
#include "report/json_object.h"
#include "report/reach_data.h"
#include "results/answer.h"
#include "results/answer_shares.h"
#include "results/fault_line.h"
#include "results/lost.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

Json at_point(const Plan& plan, std::size_t point) {
  Json at = Json::object();
  for (std::size_t a = 0; a < plan.axes.size(); ++a) {
    const SweepAxis& axis = plan.axes[a];
    const double value = plan.at[point][a];
    at[axis.path] = axis.is_choice() ? Json(axis.label(value)) : Json(value);
  }
  return at;
}

/// "nscd", or "nscd, ballistic" where the method is swept.
std::string methods_text(const Plan& plan) {
  std::string text;
  for (const Method method : plan.methods()) (text += text.empty() ? "" : ", ") += name_of(method);
  return text;
}

/// { p95: [lower, upper], ... } for the statistics that have an interval.
Json intervals_data(const Intervals& intervals) {
  Json data = Json::object();
  for (const Statistic s :
       {Statistic::mean, Statistic::p50, Statistic::p90, Statistic::p95, Statistic::p99}) {
    const Interval& interval = intervals[static_cast<int>(s)];
    data[std::string(statistic_names[static_cast<int>(s)])] = interval_data(interval);
  }
  return data;
}

Json statistics_data(const Statistics& statistics) {
  Json data = Json::object();
  Json bounds = Json::array();
  for (std::size_t s = 0; s < statistics.size(); ++s) {
    const std::string name(statistic_names[s]);
    data[name] = number(statistics[s].value);
    if (statistics[s].censored) bounds.push_back(name);
  }
  data["lower_bounds"] = bounds;
  return data;
}

Json group_data(const GroupSummary& group) {
  Json reasons = Json::object(), intervals = {{"censored", interval_data(group.censored_interval())}};
  for (std::size_t r = 0; r < group.reasons.size(); ++r) {
    const char* name = name_of(static_cast<StopReason>(r));
    reasons[name] = group.reasons[r];
    intervals[name] = interval_data(share_interval(group.reasons[r], group.count, stated_confidence));
  }
  Json data = {{"group", group.name.empty() ? Json(nullptr) : Json(group.name)},
               {"count", group.count},
               {"faults", group.faults},
               {"censored", group.censored_share()},
               {"stop_reasons", reasons},
               {"share_intervals", intervals}};
  Json time = Json::object(), distance = Json::object();
  for (std::size_t m = 0; m < travel_mode_names.size(); ++m) {
    time[travel_mode_names[m]] = number(group.time_share[m]);
    distance[travel_mode_names[m]] = number(group.distance_share[m]);
  }
  data["travel"] = {{"time", time}, {"distance", distance}};
  for (std::size_t q = 0; q < quantity_names.size(); ++q) {
    Json& quantity = data[std::string(quantity_names[q])] = statistics_data(group.statistics[q]);
    quantity["intervals"] = intervals_data(group.intervals[q]);
  }
  return data;
}

/// Makes all numbers in a value null. What tells bounds from values has nothing left to tell.
void forget(Json& value) {
  if (value.is_number()) value = nullptr;
  if (value.is_boolean()) value = false;
  if (value.is_array() && !value.empty() && value.front().is_string()) value = Json::array();
  if (value.is_structured())
    for (Json& inner : value) forget(inner);
}

/// The same for the members of a map, except those named in `kept`, and says why.
void forget_numbers(Json& data, const std::vector<std::string>& kept) {
  for (auto& [key, value] : data.items())
    if (std::find(kept.begin(), kept.end(), key) == kept.end()) forget(value);
  data["reason"] = "lost";
}

/// What is left of a point that lost too many rocks: counts, stop reasons, places and what was asked for.
void forget_statistics(Json& point) {
  for (Json& group : point["rocks"]) forget_numbers(group, {"group", "count", "faults", "stop_reasons"});
  for (Json& gate : point["gates"]) forget_numbers(gate, {"gate", "x", "line", "rocks"});
  for (Json& barrier : point["barriers"])
    forget_numbers(
        barrier, {"barrier", "x", "line", "height_m", "capacity_J", "inclination_deg", "freeboard_m", "level",
                  "energy_factor", "height_factor", "held_height_m", "held_energy_J", "rocks", "counts"});
  if (point.contains("trees")) forget_numbers(point["trees"], {"hits", "counts"});
  for (Json& clearance : point["clearance"]) {
    forget_numbers(clearance, {"clearance", "group", "probability", "per", "of", "count", "rocks_per_blast",
                               "needed", "confidence", "factor", "area"});
    if (clearance.contains("area")) clearance["area"]["sectors"] = Json::array();
  }
  for (Json& azimuths : point["runout_by_azimuth"])
    if (azimuths.contains("sectors")) azimuths["sectors"] = Json::array();
}

/// Where a gate or barrier stands: at x, or along a line [[x, y], ...]; the other is null.
template <class Place>
Json x_of(const Place& place) {
  return place.line.empty() ? Json(place.x) : Json(nullptr);
}
template <class Place>
Json line_of(const Place& place) {
  if (place.line.empty()) return nullptr;
  Json line = Json::array();
  for (const Vec2& point : place.line) line.push_back({point.x(), point.y()});
  return line;
}

Json gates_data(const Scenario& scenario, const std::vector<GateSummary>& gates) {
  Json list = Json::array();
  for (std::size_t g = 0; g < gates.size(); ++g)
    list.push_back({{"gate", scenario.gates[g].name},
                    {"x", x_of(scenario.gates[g])},
                    {"line", line_of(scenario.gates[g])},
                    {"rocks", gates[g].passed},
                    {"passed", number(gates[g].share.value)},
                    {"share_intervals", {{"passed", interval_data(gates[g].share.interval)}}},
                    {"lower_bounds", gates[g].share.censored},
                    {"speed", statistics_data(gates[g].speed)},
                    {"energy", statistics_data(gates[g].energy)},
                    {"height", statistics_data(gates[g].height)}});
  return list;
}

Json barriers_data(const Scenario& scenario, const std::vector<BarrierSummary>& barriers) {
  Json list = Json::array();
  for (std::size_t b = 0; b < barriers.size(); ++b) {
    const BarrierSummary& barrier = barriers[b];
    const BarrierPlan& plan = scenario.barriers[b];
    Json data = {{"barrier", plan.name},
                 {"x", x_of(plan)},
                 {"line", line_of(plan)},
                 {"height_m", plan.height},
                 {"capacity_J", plan.capacity},
                 {"inclination_deg", plan.inclination * 180 / pi},
                 {"freeboard_m", plan.freeboard},
                 {"level", plan.service_level ? "sel" : "mel"},
                 {"energy_factor", plan.energy_factor},
                 {"height_factor", plan.height_factor},
                 {"held_height_m", plan.held_height()},
                 {"held_energy_J", plan.held_energy()},
                 {"rocks", barrier.outcomes[0] + barrier.outcomes[1] + barrier.outcomes[2]},
                 {"reached", number(barrier.reached.value)}};
    const Complement others = complement_of(barrier.reached);
    Json counts = Json::object(), intervals = {{"reached", interval_data(barrier.reached.interval)}};
    for (std::size_t o = 0; o < barrier.shares.size(); ++o) {
      const char* name = name_of(static_cast<BarrierOutcome>(o));
      data[name] = number(barrier.shares[o].value);
      intervals[name] = interval_data(barrier.shares[o].interval);
      counts[name] = barrier.outcomes[o];
    }
    data["past"] = number(barrier.past.value);
    intervals["past"] = interval_data(barrier.past.interval);
    data["not_reached"] = number(others.value);
    intervals["not_reached"] = interval_data(others.interval);
    counts["not_reached"] = barrier.not_reached;
    data["counts"] = counts;
    data["share_intervals"] = intervals;
    data["lower_bounds"] = barrier.reached.censored;
    data["energy"] = statistics_data(barrier.energy);
    data["height"] = statistics_data(barrier.height);
    list.push_back(std::move(data));
  }
  return list;
}

/// { hits, mean_hits, hit, hit_interval, stopped, stopped_interval, counts: { hit, stopped }, lower_bounds }:
/// shares of all rocks.
Json trees_data(const TreeSummary& trees) {
  return {{"hits", trees.hits},
          {"mean_hits", number(trees.mean_hits)},
          {"hit", number(trees.hit_share.value)},
          {"hit_interval", interval_data(trees.hit_share.interval)},
          {"stopped", number(trees.stopped_share.value)},
          {"stopped_interval", interval_data(trees.stopped_share.interval)},
          {"counts", {{"hit", trees.hit}, {"stopped", trees.stopped}}},
          {"lower_bounds", trees.stopped_share.censored}};
}

/// The distance by azimuth about (x, y), from a hull: { x, y, hull: [[x, y], ...], sectors: [{ azimuth_deg,
/// count, share, share_interval, greatest, distance, lower, upper, lower_bound, with_factor }] }. If no rock
/// ended in a sector, everything but its count is null: no data.
Json area_data(const AreaSummary& area) {
  Json hull = Json::array(), list = Json::array();
  for (const Vec2& corner : area.hull) hull.push_back({corner.x(), corner.y()});
  for (const SectorSummary& sector : area.sectors)
    list.push_back({{"azimuth_deg", sector.azimuth * 180 / pi},
                    {"count", sector.count},
                    {"share", number(sector.share.value)},
                    {"share_interval", interval_data(sector.share.interval)},
                    {"greatest", number(sector.greatest.value)},
                    {"distance", number(sector.distance.value)},
                    {"lower", number(sector.interval.lower)},
                    {"upper", number(sector.interval.upper)},
                    {"lower_bound", sector.greatest.censored},
                    {"with_factor", number(sector.with_factor)}});
  return {{"x", area.centre.x()}, {"y", area.centre.y()}, {"hull", hull}, {"sectors", list}};
}

Json clearances_data(const Scenario& scenario, const std::vector<ClearanceSummary>& clearances) {
  Json list = Json::array();
  for (std::size_t c = 0; c < clearances.size(); ++c) {
    const ClearancePlan& plan = scenario.clearances[c];
    const ClearanceSummary& clearance = clearances[c];
    list.push_back(
        {{"clearance", plan.name},
         {"group", plan.group < 0 ? Json(nullptr)
                                  : Json(scenario.rocks.at(static_cast<std::size_t>(plan.group)).name)},
         {"probability", plan.probability},
         {"per", plan.per_blast ? "blast" : "rock"},
         {"of", plan.of_max_distance ? "max_distance" : "runout"},
         {"count", clearance.count},
         {"rocks_per_blast", plan.per_blast ? number(clearance.rocks_per_blast()) : Json(nullptr)},
         {"needed", clearance.needed},
         {"distance", number(clearance.distance.value)},
         {"lower_bound", clearance.distance.censored},
         {"confidence", plan.confidence},
         {"lower", number(clearance.interval.lower)},
         {"upper", number(clearance.interval.upper)},
         {"factor", plan.factor ? Json(*plan.factor) : Json(nullptr)},
         {"with_factor", number(clearance.with_factor)}});
    if (plan.sectors > 0) list.back()["area"] = area_data(clearance.area);
  }
  return list;
}

/// [{ reason, part, material, rocks, x: [from, to], y: [from, to] }]
Json censored_data(const Scenario& scenario, const PointResult& point) {
  const auto name = [](const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); };
  Json list = Json::array();
  for (const CensoredPlace& place : point.censored) {
    const auto part = static_cast<std::size_t>(place.part);
    list.push_back(
        {{"reason", name_of(place.reason)},
         {"part",
          name(place.part >= 0 && part < point.terrain.parts.size() ? point.terrain.parts[part] : "")},
         {"material", name(material_of(scenario, point, place.part))},
         {"rocks", place.rocks},
         {"x", {place.low.x(), place.high.x()}},
         {"y", {place.low.y(), place.high.y()}}});
  }
  return list;
}

Json quality_data(const SolverQuality& q) {
  return {{"steps", q.steps},
          {"cut_steps", q.cut_steps},
          {"refused_steps", q.refused_steps},
          {"least_step", number(q.least_step)},
          {"mean_step", number(q.steps > 0 ? q.step_time / static_cast<double>(q.steps) : 0)},
          {"greatest_step", number(q.greatest_step)},
          {"flights", q.flights},
          {"impact_problems", q.impact_problems},
          {"problems", q.problems},
          {"iterations", q.iterations},
          {"toc_iterations", q.toc_iterations},
          {"not_converged", q.not_converged},
          {"not_converged_residual", number(q.not_converged_residual)},
          {"max_residual", number(q.max_residual)},
          {"max_penetration", number(q.max_penetration)},
          {"max_spring_angle", number(q.max_spring_angle)},
          {"energy_gains", q.energy_gains},
          {"energy_gained", number(q.energy_gained)},
          {"shocks", q.shocks},
          {"energy_relative_change", number(q.energy_relative_change)}};
}

/// How often each law was called; null if the material has no such law.
Json materials_data(const Scenario& scenario, const std::vector<MaterialUse>& use) {
  const auto asked = [](const std::optional<PluginUse>& law, std::uint64_t times) {
    return law ? Json(times) : Json(nullptr);
  };
  Json list = Json::array();
  for (std::size_t m = 0; m < use.size() && m < scenario.materials.size(); ++m) {
    const Material& material = scenario.materials[m];
    list.push_back({{"material", material.name},
                    {"contacts", use[m].contacts},
                    {"restitution", asked(material.restitution, use[m].restitution)},
                    {"friction", asked(material.friction, use[m].friction)},
                    {"rolling", asked(material.rolling, use[m].rolling)},
                    {"unilateral", asked(material.unilateral, use[m].unilateral)}});
  }
  return list;
}

Json verdict_data(const Verdict& verdict) {
  const Expectation& e = verdict.expectation;
  Json data = {{"measure", e.measure},
               {"point", verdict.point < 0 ? Json(nullptr) : Json(verdict.point)},
               {"computed", number(verdict.computed)},
               {"kind", expect_kind_names[static_cast<std::size_t>(e.kind)]}};
  data["expected"] = e.kind == ExpectKind::between ? Json::array({e.value, e.high}) : Json(e.value);
  data["tolerance"] = verdict.tolerance;
  data["passed"] = verdict.judgement == Judgement::not_judged ? Json(nullptr)
                                                              : Json(verdict.judgement == Judgement::passed);
  if (!verdict.reason.empty()) data["reason"] = verdict.reason;
  return data;
}

/// The design of the blast, with the medians of distributions; null if the scenario does not give enough.
Json blast_data(const BlastPlan& plan) {
  const BlastDesign& design = plan.design;
  return {{"holes", plan.pattern.holes()},
          {"charge_kg_per_m", number(design.linear_charge)},
          {"charge_per_hole_kg", number(design.charge_per_hole)},
          {"explosive_kg", number(design.explosive)},
          {"rock_m3", number(design.rock)},
          {"powder_factor_kg_m3", number(design.powder_factor)},
          {"powder_factor_shallow_kg_m3", number(design.powder_factor_shallow)},
          {"powder_factor_deep_kg_m3", number(design.powder_factor_deep)},
          {"burden_m", number(plan.typical[BlastField::burden])},
          {"scaled_depth_of_burial_m_kg13", number(design.depth_of_burial)},
          {"farthest_fragment_m", number(design.fragment)},
          {"last_hole_s", number(design.last_time)}};
}

}  // namespace

nlohmann::ordered_json summary_data(const Plan& plan, const Results& results) {
  const Scenario& first = plan.points.front();
  Json points = Json::array();
  for (std::size_t p = 0; p < results.points.size(); ++p) {
    const PointResult& point = results.points[p];
    Json groups = Json::array();
    for (const GroupSummary& group : point.groups) groups.push_back(group_data(group));
    points.push_back({{"point", p},
                      {"at", at_point(plan, p)},
                      {"trials", point.trials},
                      {"rocks", groups},
                      {"censored", censored_data(plan.points[p], point)},
                      {"runout_by_azimuth", azimuth_data(point)},
                      {"gates", gates_data(plan.points[p], point.gates)},
                      {"barriers", barriers_data(plan.points[p], point.barriers)},
                      {"clearance", clearances_data(plan.points[p], point.clearances)},
                      {"reach", reach_data(plan.points[p], point.reaches)},
                      {"solver", quality_data(point.totals.quality)},
                      {"materials", materials_data(plan.points[p], point.totals.materials)}});
    if (point.trees) points.back()["trees"] = trees_data(*point.trees);
    if (const OutputPlan& output = plan.points[p].output; !output.rocks) {
      const std::uint64_t all = point.groups.front().count;
      points.back()["rows"] =
          std::to_string(std::min<std::uint64_t>(all, static_cast<std::uint64_t>(output.first))) + " of " +
          std::to_string(all);
    }
    if (has_lost(plan.points[p], point)) forget_statistics(points.back());
    if (plan.points[p].blast) points.back()["blast"] = blast_data(*plan.points[p].blast);
  }
  Json verdicts = Json::array();
  for (const Verdict& verdict : results.verdicts) verdicts.push_back(verdict_data(verdict));
  Json faults = Json::array();
  for (const Fault& fault : results.faults)
    faults.push_back({{"point", fault.point},
                      {"trial", fault.trial},
                      {"rock", fault.rock},
                      {"reason", name_of(fault.reason)},
                      {"text", fault.text}});
  Json data = {{"flyrock", FLYROCK_ENGINE_VERSION},
               {"title", first.title},
               {"fault_line", fault_line(plan, results)},
               {"answer", answer(plan, results)},
               {"assumptions", assumptions(plan)},
               {"dimension", first.dimension},
               {"method", methods_text(plan)},
               {"seed", first.seed},
               {"trials", first.trials},
               {"complete", results.ended_early.empty()}};
  if (!results.ended_early.empty()) data["ended_early"] = results.ended_early;
  data["points"] = points;
  data["expectations"] = verdicts;
  data["fault_count"] = results.fault_count;
  data["faults"] = faults;
  data["not_used"] = plan.not_used;
  data["not_asked"] = results.not_asked;
  data["warnings"] = results.warnings;
  return data;
}

}  // namespace flyrock
