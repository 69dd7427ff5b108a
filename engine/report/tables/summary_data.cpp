#include "report/tables/summary_data.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/bearing.h"
#include "report/tables/azimuth_data.h"
#include "report/tables/comparison_data.h"
#include "report/tables/exposure_data.h"
#include "report/tables/json_object.h"
#include "report/tables/observation_data.h"
#include "report/tables/outer_data.h"
#include "report/tables/reach_data.h"
#include "report/tables/risk_data.h"
#include "results/measured/lost.h"
#include "results/say/answer.h"
#include "results/say/answer_shares.h"
#include "results/say/fault_line.h"
#include "results/say/weights.h"
#include "scenario/derived_inputs.h"
#include "scenario/plan.h"

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

/// The statistics that have an interval.
constexpr std::array with_interval = {Statistic::mean, Statistic::p50, Statistic::p90, Statistic::p95,
                                      Statistic::p99};

/// { p95: of(its interval), ... }
template <class Of>
Json each_interval(const Intervals& intervals, Of of) {
  Json data = Json::object();
  for (const Statistic s : with_interval)
    data[std::string(statistic_names[static_cast<std::size_t>(s)])] =
        of(intervals[static_cast<std::size_t>(s)]);
  return data;
}
Json intervals_data(const Intervals& intervals) {
  return each_interval(intervals, [](const Interval& interval) { return interval_data(interval); });
}
Json design_effects_data(const Intervals& intervals) {
  return each_interval(intervals, [](const Interval& interval) { return number(interval.design_effect); });
}
/// null: there are enough trials.
Json trials_needed_data(const Intervals& intervals) {
  return each_interval(intervals, [](const Interval& interval) {
    return interval.trials_needed > 0 ? Json(interval.trials_needed) : Json(nullptr);
  });
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
  Json reasons = Json::object(), intervals = {{"censored", interval_data(group.censored_share.interval)}};
  for (std::size_t r = 0; r < group.reasons.size(); ++r) {
    const char* name = name_of(static_cast<StopReason>(r));
    reasons[name] = group.reasons[r];
    intervals[name] = interval_data(group.reason_shares[r].interval);
  }
  Json data = {{"group", group.name.empty() ? Json(nullptr) : Json(group.name)},
               {"count", group.count},
               {"faults", group.faults},
               {"censored", number(group.censored_share.value)},
               {"stop_reasons", reasons},
               {"share_intervals", intervals}};
  Json time = Json::object(), distance = Json::object();
  for (std::size_t m = 0; m < travel_mode_names.size(); ++m) {
    time[travel_mode_names[m]] = number(group.time_share[m]);
    distance[travel_mode_names[m]] = number(group.distance_share[m]);
  }
  data["travel"] = {{"time", time}, {"distance", distance}};
  for (std::size_t q = 0; q < rock_statistics.size(); ++q) {
    Json& quantity = data[std::string(rock_statistics[q].name())] = statistics_data(group.statistics[q]);
    quantity["intervals"] = intervals_data(group.intervals[q]);
    quantity["design_effect"] = design_effects_data(group.intervals[q]);
    quantity["trials_needed"] = trials_needed_data(group.intervals[q]);
  }
  return data;
}

/// Says why the numbers of a point are null that lost too many rocks.
void say_lost(Json& point) {
  for (const char* list : {"rocks", "gates", "barriers", "clearance", "exposure"})
    if (point.contains(list))
      for (Json& item : point[list]) item["reason"] = "lost";
  if (point.contains("trees")) point["trees"]["reason"] = "lost";
  for (Json& clearance : point["clearance"])
    if (clearance.contains("area_least")) clearance["area_least"]["reason"] = "lost";
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

/// { of_all, of_arriving, per_trial: { share, interval, design_effect, lower_bound } }; per_trial also has
/// the members of bounds_data().
Json share_data(const Share& share) {
  return {{"share", number(share.value)},
          {"interval", interval_data(share.interval)},
          {"design_effect", number(share.interval.design_effect)},
          {"lower_bound", share.censored}};
}
Json shares_data(const Shares& shares) {
  Json per_trial = bounds_data(shares.blast);
  per_trial["design_effect"] = number(shares.per_trial.interval.design_effect);
  per_trial["lower_bound"] = shares.per_trial.censored;
  return {{"of_all", share_data(shares.of_all)},
          {"of_arriving", share_data(shares.of_arriving)},
          {"per_trial", per_trial}};
}

/// The numbers of arrivals, with their intervals.
Json arrivals_data(const Statistics& statistics, const Intervals& intervals) {
  Json data = statistics_data(statistics);
  data["intervals"] = intervals_data(intervals);
  data["design_effect"] = design_effects_data(intervals);
  return data;
}

/// { bin_m, from_m, rocks: [...] }: arrivals along the line of a gate, in 3D.
Json along_data(const std::map<int, double>& bins) {
  Json rocks = Json::array();
  if (bins.empty()) return {{"bin_m", bin_along}, {"from_m", 0}, {"rocks", rocks}};
  const int first = bins.begin()->first, last = bins.rbegin()->first;
  for (int bin = first; bin <= last; ++bin) {
    const auto found = bins.find(bin);
    rocks.push_back(found == bins.end() ? 0 : found->second);
  }
  return {{"bin_m", bin_along}, {"from_m", first * bin_along}, {"rocks", rocks}};
}

/// What rocks of one group, or all rocks, did at a gate: { rocks, passed, share_intervals, ... }.
void add_gate(Json& data, const GateSummary& gate, int dimension) {
  if (dimension == 3) data["along"] = along_data(gate.along);
  data["rocks"] = gate.passed;
  data["passed"] = number(gate.shares.of_all.value);
  data["share_intervals"] = {{"passed", interval_data(gate.shares.of_all.interval)}};
  data["shares"] = {{"passed", shares_data(gate.shares)}};
  data["lower_bounds"] = gate.shares.of_all.censored;
  data["speed"] = arrivals_data(gate.speed, gate.speed_intervals);
  data["energy"] = arrivals_data(gate.energy, gate.energy_intervals);
  data["height"] = arrivals_data(gate.height, gate.height_intervals);
}

void add_barrier(Json& data, const BarrierSummary& barrier) {
  const Share& reached = barrier.share(BarrierShare::reached).of_all;
  const Complement others = complement_of(reached);
  data["rocks"] = barrier.count(BarrierShare::reached);
  Json counts = Json::object(), intervals = Json::object(), shares = Json::object();
  for (std::size_t s = 0; s < barrier_share_names.size(); ++s) {
    const std::string name(barrier_share_names[s]);
    data[name] = number(barrier.shares[s].of_all.value);
    intervals[name] = interval_data(barrier.shares[s].of_all.interval);
    counts[name] = barrier.counts[s];
    shares[name] = shares_data(barrier.shares[s]);
  }
  data["not_reached"] = number(others.value);
  intervals["not_reached"] = interval_data(others.interval);
  counts["not_reached"] = barrier.not_reached;
  data["counts"] = counts;
  data["share_intervals"] = intervals;
  data["shares"] = shares;
  data["lower_bounds"] = reached.censored;
  data["energy"] = arrivals_data(barrier.energy, barrier.energy_intervals);
  data["height"] = arrivals_data(barrier.height, barrier.height_intervals);
}

/// A list of what each group did, if there is more than one.
template <class Add>
Json groups_data(const PointResult& point, Add add) {
  Json list = Json::array();
  for (std::size_t g = 1; g < point.crossings.size(); ++g) {
    list.push_back({{"group", point.groups.at(g).name}});
    add(list.back(), point.crossings[g]);
  }
  return list;
}

Json gates_data(const Scenario& scenario, const PointResult& point) {
  Json list = Json::array();
  for (std::size_t g = 0; g < scenario.gates.size(); ++g) {
    const GatePlan& plan = scenario.gates[g];
    Json& data = list.emplace_back(Json{{"gate", plan.name}, {"x", x_of(plan)}, {"line", line_of(plan)}});
    add_gate(data, point.crossings.front().gates[g], scenario.dimension);
    data["groups"] = groups_data(point, [&](Json& to, const CrossingSummary& group) {
      add_gate(to, group.gates[g], scenario.dimension);
    });
  }
  return list;
}

Json barriers_data(const Scenario& scenario, const PointResult& point) {
  Json list = Json::array();
  for (std::size_t b = 0; b < scenario.barriers.size(); ++b) {
    const BarrierPlan& plan = scenario.barriers[b];
    Json& data = list.emplace_back(Json{{"barrier", plan.name},
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
                                        {"held_energy_J", plan.held_energy()}});
    add_barrier(data, point.crossings.front().barriers[b]);
    data["groups"] = groups_data(
        point, [b](Json& to, const CrossingSummary& group) { add_barrier(to, group.barriers[b]); });
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

/// The blocks between joints: { trials, all, removable, ...: { count, count_interval, volume_m3,
/// volume_m3_interval }, ..., sizes: [[m3, share of the blocks, share of the volume], ...] }.
Json blocks_data(const BlockSummary& blocks) {
  Json data = {{"trials", blocks.trials}};
  for (std::size_t part = 0; part < block_part_names.size(); ++part)
    data[std::string(block_part_names[part])] = {
        {"count", number(blocks.count[part].mean)},
        {"count_interval", interval_data(blocks.count[part].interval)},
        {"volume_m3", number(blocks.volume[part].mean)},
        {"volume_m3_interval", interval_data(blocks.volume[part].interval)}};
  data.update(Json{{"region_m3", number(blocks.region_volume)},
                   {"joints", number(blocks.joints)},
                   {"joint_area_m2_per_m3", number(blocks.joint_area)},
                   {"joint_count_per_m", number(blocks.joint_count)},
                   {"mean_m3", number(blocks.mean_volume)},
                   {"mean_by_volume_m3", number(blocks.weighted_volume)},
                   {"left_out", number(blocks.left_out)},
                   {"left_out_m3", number(blocks.left_out_volume)}});
  Json sizes = Json::array();
  for (const BlockSize& size : blocks.sizes) sizes.push_back({size.volume, size.of_blocks, size.of_volume});
  data["sizes"] = sizes;
  return data;
}

/// The area about (x, y), from a hull: { x, y, hull: [[x, y], ...], beyond, effective, sectors: [{
/// azimuth_deg, bearing_deg, count, share, share_interval, greatest, distance, lower_bound, with_factor }] }.
/// `beyond` is null where there is no area.
Json area_data(const AreaSummary& area, double north) {
  Json hull = Json::array(), list = Json::array();
  for (const Vec2& corner : area.hull) hull.push_back({corner.x(), corner.y()});
  for (const SectorSummary& sector : area.sectors)
    list.push_back({{"azimuth_deg", sector.azimuth * 180 / pi},
                    {"bearing_deg", bearing_degrees(sector.azimuth, north)},
                    {"count", sector.count},
                    {"share", number(sector.share.value)},
                    {"share_interval", interval_data(sector.share.interval)},
                    {"greatest", number(sector.greatest.value)},
                    {"distance", number(sector.distance.value)},
                    {"lower_bound", sector.greatest.censored},
                    {"with_factor", number(sector.with_factor)}});
  return {{"x", number(area.centre.x())},
          {"y", number(area.centre.y())},
          {"hull", hull},
          {"beyond", area.beyond ? Json(*area.beyond) : Json(nullptr)},
          {"effective", number(area.effective)},
          {"sectors", list}};
}

/// { hectares, probability, radius, beyond, effective, censored, polygons: [[[x, y], ...], ...] }. Without an
/// area `hectares` and `beyond` are null.
Json least_area_data(const ClearancePlan& plan, const LeastArea& area) {
  Json polygons = Json::array();
  const auto to_millimetres = [](double length) { return std::round(1000 * length) / 1000; };
  for (const PlanRing& ring : area.polygons) {
    Json& corners = polygons.emplace_back(Json::array());
    for (const Vec2& corner : ring)
      corners.push_back({to_millimetres(corner.x()), to_millimetres(corner.y())});
  }
  return {{"hectares", number(area.hectares)},
          {"probability", plan.probability},
          {"radius", number(area.radius)},
          {"beyond", area.beyond ? Json(*area.beyond) : Json(nullptr)},
          {"effective", number(area.effective)},
          {"censored", area.censored},
          {"polygons", polygons}};
}

/// { distance, share, lower, upper, interval, telling_weight, lower_bound }
Json blasts_beyond_data(const BlastsBeyond& beyond) {
  Json data = {{"distance", beyond.distance}};
  data.update(bounds_data(beyond.share));
  data["lower_bound"] = beyond.is_lower_bound;
  return data;
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
         {"design_effect", number(clearance.interval.design_effect)},
         {"trials_needed",
          clearance.interval.trials_needed > 0 ? Json(clearance.interval.trials_needed) : Json(nullptr)},
         {"factor", plan.factor ? Json(*plan.factor) : Json(nullptr)},
         {"with_factor", number(clearance.with_factor)}});
    if (clearance.is_upper_bound(plan)) {
      list.back()["upper_bound"] = true;
      list.back()["weight"] = clearance.weight;
    }
    if (!std::isnan(clearance.beyond_distance.distance))
      list.back()["blasts_beyond"] = blasts_beyond_data(clearance.beyond_distance);
    if (plan.blasts_per_year) list.back()["blasts_per_year"] = *plan.blasts_per_year;
    if (plan.customary) {
      list.back()["customary"] = *plan.customary;
      list.back()["blasts_beyond_customary"] = blasts_beyond_data(*clearance.beyond_customary);
    }
    if (plan.known_throw) {
      list.back()["known_throw"] = *plan.known_throw;
      list.back()["beyond_known_throw"] = beyond_known_throw * *plan.known_throw;
    }
    if (plan.sectors > 0) list.back()["area"] = area_data(clearance.area, scenario.terrain.north);
    if (!plan.least_area) continue;
    list.back()["area_least"] = least_area_data(plan, clearance.least_area);
    list.back()["circle_hectares"] = number(clearance.least_area.circle_hectares);
    list.back()["circle_distance"] = number(clearance.least_area.circle_distance);
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
          {"gains_by_slip", q.gains_by_slip},
          {"gained_by_slip", number(q.gained_by_slip)},
          {"endless_impacts", q.endless_impacts},
          {"shocks", q.shocks},
          {"dense_steps", q.dense_steps},
          {"dense_unfinished", q.dense_unfinished},
          {"dense_residual", number(q.dense_residual)},
          {"unsolved_depth", number(q.unsolved_depth)},
          {"theta_loss", number(q.theta_loss)},
          {"projection_energy", number(q.projection_energy)},
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
  Json data = {{"measure", compared_text(e)},
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

/// The rows of the table of questions, and the clause of each in the first sentence.
Json questions_data(const std::vector<Question>& questions) {
  Json list = Json::array();
  for (const Question& q : questions)
    list.push_back({{"asks", q.asks},
                    {"per_blast", q.per_blast},
                    {"interval", q.interval},
                    {"per_year", q.per_year},
                    {"limit", q.limit},
                    {"verdict", q.verdict},
                    {"clause", q.clause}});
  return list;
}

/// The head of the report, what is given of it.
Json document_data(const DocumentPlan& head) {
  Json data = Json::object();
  for (const auto& [key, text] :
       std::initializer_list<std::pair<const char*, const std::string&>>{{"number", head.number},
                                                                         {"site", head.site},
                                                                         {"client", head.client},
                                                                         {"author", head.author},
                                                                         {"checked_by", head.checked_by},
                                                                         {"revision", head.revision},
                                                                         {"date", head.date}})
    if (!text.empty()) data[key] = text;
  if (head.signature) data["signature"] = true;
  return data;
}

/// The derived numbers of the blast, with the medians of distributions, and what each is made of.
Json derived_data(const BlastPlan& plan) {
  const DerivedNumbers numbers = typical_derived(plan);
  Json list = Json::array();
  for (std::size_t d = 0; d < derived_count; ++d)
    if (std::isfinite(numbers[d])) {
      const auto derived = static_cast<Derived>(d);
      list.push_back({{"path", path_of(derived)},
                      {"value", numbers[d]},
                      {"unit", derived_infos()[d].unit},
                      {"of", paths_made_of(plan, derived)}});
    }
  return list;
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
          {"last_hole_s", number(design.last_time)},
          {"derived", derived_data(plan)}};
}

}  // namespace

nlohmann::ordered_json summary_data(const Plan& plan, const Results& results) {
  const Scenario& first = plan.points.front();
  const bool weighted = has_weights(plan, results);
  Json points = Json::array();
  for (std::size_t p = 0; p < results.points.size(); ++p) {
    const PointResult& point = results.points[p];
    Json groups = Json::array();
    for (const GroupSummary& group : point.groups) {
      groups.push_back(group_data(group));
      if (weighted) groups.back()["weight"] = number(group.weight);
    }
    points.push_back({{"point", p},
                      {"at", at_point(plan, p)},
                      {"trials", point.trials},
                      {"rocks", groups},
                      {"censored", censored_data(plan.points[p], point)},
                      {"runout_by_azimuth", azimuth_data(point, plan.points[p].terrain.north)},
                      {"gates", gates_data(plan.points[p], point)},
                      {"barriers", barriers_data(plan.points[p], point)},
                      {"clearance", clearances_data(plan.points[p], point.clearances)},
                      {"reach", reach_data(plan.points[p], point.reaches)},
                      {"solver", quality_data(point.totals.quality)},
                      {"materials", materials_data(plan.points[p], point.totals.materials)}});
    if (point.trees) points.back()["trees"] = trees_data(*point.trees);
    if (point.blocks) points.back()["blocks"] = blocks_data(*point.blocks);
    if (const OutputPlan& output = plan.points[p].output; !output.rocks) {
      const std::uint64_t all = point.groups.front().count;
      points.back()["rows"] =
          std::to_string(std::min<std::uint64_t>(all, static_cast<std::uint64_t>(output.first))) + " of " +
          std::to_string(all);
    }
    if (!plan.points[p].exposures.empty())
      points.back()["exposure"] = exposures_data(plan.points[p], point.exposures);
    if (const std::vector<Question> asked = questions(plan.points[p], point); !asked.empty())
      points.back()["questions"] = questions_data(asked);
    if (has_lost(plan.points[p], point)) say_lost(points.back());
    if (point.observation)
      points.back()["observed"] = has_lost(plan.points[p], point)
                                      ? Json{{"reason", "lost"}}
                                      : observation_data(*plan.points[p].observed, *point.observation);
    if (point.outer) points.back()["outer"] = outer_data(*point.outer);
    if (!plan.points[p].branches.empty())
      points.back()["branches"] = branches_data(plan.points[p], point.risk);
    if (const auto& blast = plan.points[p].blast) {
      points.back()["blast"] = blast_data(*blast);
      add_hole_data(points.back()["blast"], *blast, point.risk.risks);
    }
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
               {"seed", first.streams.seed},
               {"trials", first.trials},
               {"complete", results.ended_early.empty()}};
  if (const std::string sentence = answer_texts(plan, results).first; !sentence.empty())
    data["first_sentence"] = sentence;
  if (const Json head = document_data(first.document); !head.empty()) data["document"] = head;
  if (!first.terrain.crs.empty()) data["crs"] = first.terrain.crs;
  if (first.dimension == 3) data["north_deg"] = std::round(first.terrain.north * 180 / pi * 1e9) / 1e9;
  if (!results.ended_early.empty()) data["ended_early"] = results.ended_early;
  if (results.best) data["best_point"] = best_point_data(plan, *results.best);
  if (weighted) data["weights"] = meaning_of_weights;
  data["points"] = points;
  if (!results.differences.empty()) data["differences"] = differences_data(plan, results);
  data["expectations"] = verdicts;
  data["fault_count"] = results.fault_count;
  data["faults"] = faults;
  data["not_used"] = plan.not_used;
  data["not_asked"] = results.not_asked;
  data["warnings"] = results.warnings;
  return data;
}

}  // namespace flyrock
