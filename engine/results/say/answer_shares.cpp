#include "results/say/answer_shares.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "results/say/weights.h"
#include "results/say/wording.h"
#include "scenario/plan.h"

namespace flyrock {

namespace {

/// "x from 120 to 180 m"; in 3D also for y.
std::string range_text(const char* axis, double low, double high) {
  // National coordinates have seven digits before the point.
  const auto text = [](double place) {
    return std::abs(place) < 1e4 ? fmt::format("{:.4g}", place) : fmt::format("{:.1f}", place);
  };
  const std::string from = text(low), to = text(high);
  return from == to ? fmt::format("{} = {} m", axis, from)
                    : fmt::format("{} from {} to {} m", axis, from, to);
}

/// "3 ran out of time (60 s) on haul_floor (part floor), x from 120 to 180 m"
std::string why_and_where(const Scenario& scenario, const PointResult& point, const CensoredPlace& place) {
  const std::string why = place.reason == StopReason::left_domain
                              ? "left the domain"
                              : fmt::format("ran out of time ({:.4g} s)", scenario.stop.time);
  return fmt::format("{} {} {}", place.rocks, why, place_text(scenario, point, place));
}

/// "Barrier fence catches 1 of 2 bodies; ... ": bodies are few, and shares of them say less than their count.
std::string of_bodies(const std::string& name, const BarrierSummary& barrier) {
  const std::uint64_t caught = barrier.count(BarrierShare::caught),
                      over_top = barrier.count(BarrierShare::over_top),
                      through = barrier.count(BarrierShare::over_energy);
  const std::uint64_t all = barrier.count(BarrierShare::reached) + barrier.not_reached;
  return fmt::format(
      "Barrier {} catches {} of {} {}; {} over the top, {} through it, and {} did not reach it. ", name,
      caught, all, all == 1 ? "body" : "bodies", over_top, through, barrier.not_reached);
}

constexpr std::size_t most_groups_named = 4;  // more are too many for sentences

/// The groups of which sentences speak: all rocks, where there is one group, else those of which `is_there`
/// is true at some point. With weights all rocks come first.
template <class IsThere>
std::vector<std::size_t> named_groups(const Plan& plan, const Results& results, IsThere is_there) {
  const std::size_t count = results.points.front().crossings.size();
  if (count == 1) return {0};
  std::vector<std::size_t> groups;
  if (first_shown_group(plan, results) == 0) groups.push_back(0);
  for (std::size_t g = 1; g < count && groups.size() < most_groups_named; ++g)
    if (std::any_of(results.points.begin(), results.points.end(),
                    [&](const PointResult& point) { return is_there(point.crossings[g]); }))
      groups.push_back(g);
  return groups;
}

std::string group_suffix(const Results& results, std::size_t group) {
  const std::vector<GroupSummary>& groups = results.points.front().groups;
  if (group == 0) return groups.size() > 1 ? ", all rocks (weighted)" : "";
  return ", " + groups.at(group).name;
}

/// A share over the points: share_at(point).
template <class ShareAt>
std::string share_over(const Plan& plan, const Results& results, ShareAt share_at) {
  if (results.points.size() == 1) return display(share_at(results.points.front()));
  const auto at = [&](std::size_t p) { return share_at(results.points[p]).value; };
  return over_points(plan, results, at, [&](std::size_t p) { return percent(at(p)); });
}
/// The same of a group: share_at(its crossings).
template <class ShareAt>
std::string share_over_points(const Plan& plan, const Results& results, std::size_t group, ShareAt share_at) {
  return share_over(plan, results,
                    [&](const PointResult& point) { return share_at(point.crossings.at(group)); });
}

/// The same per trial: shares_at(its crossings).
template <class SharesAt>
std::string per_trial_over_points(const Plan& plan, const Results& results, std::size_t group,
                                  SharesAt shares_at) {
  if (results.points.size() == 1)
    return display_per_trial(shares_at(results.points.front().crossings.at(group)));
  return share_over_points(plan, results, group,
                           [&](const CrossingSummary& crossings) { return shares_at(crossings).per_trial; });
}

std::string of_rocks(const std::string& name, const Plan& plan, const Results& results, std::size_t b) {
  const auto arrives = [b](const CrossingSummary& crossings) {
    return crossings.barriers.at(b).count(BarrierShare::reached) > 0;
  };
  const std::vector<std::size_t> groups = named_groups(plan, results, arrives);
  const auto reached = [b](const CrossingSummary& crossings) {
    return crossings.barriers.at(b).share(BarrierShare::reached);
  };
  const auto past = [b](const CrossingSummary& crossings) {
    return crossings.barriers.at(b).share(BarrierShare::past);
  };
  const bool any = std::any_of(results.points.begin(), results.points.end(),
                               [&](const PointResult& point) { return arrives(point.crossings.front()); });
  if (!any)
    return fmt::format("Barrier {}: in {} of the trials a rock reaches it. ", name,
                       per_trial_over_points(plan, results, 0, reached));
  std::string text;
  for (const std::size_t group : groups) {
    const auto of = [&](BarrierShare what, Share Shares::*sense) {
      return share_over_points(plan, results, group, [&](const CrossingSummary& crossings) {
        return crossings.barriers.at(b).share(what).*sense;
      });
    };
    text += fmt::format("Barrier {}{}: it catches {} of the rocks that reach it", name,
                        group_suffix(results, group), of(BarrierShare::caught, &Shares::of_arriving));
    if (results.points.size() == 1)
      text += fmt::format("; {} go over the top, {} go through it; {} of all rocks reach it",
                          of(BarrierShare::over_top, &Shares::of_arriving),
                          of(BarrierShare::over_energy, &Shares::of_arriving),
                          of(BarrierShare::reached, &Shares::of_all));
    text += fmt::format(". In {} of the trials at least one gets past. ",
                        per_trial_over_points(plan, results, group, past));
  }
  return text;
}

}  // namespace

std::string material_of(const Scenario& scenario, const PointResult& point, int part) {
  if (part < 0 || static_cast<std::size_t>(part) >= point.terrain.parts.size()) return "";
  const auto& materials = scenario.terrain.material_of_part;
  const auto found = materials.find(point.terrain.parts[static_cast<std::size_t>(part)]);
  if (found == materials.end()) return "";
  return scenario.materials.at(static_cast<std::size_t>(found->second)).name;
}

std::string place_text(const Scenario& scenario, const PointResult& point, const CensoredPlace& place) {
  std::string on;
  if (place.part >= 0 && static_cast<std::size_t>(place.part) < point.terrain.parts.size()) {
    const std::string part = point.terrain.parts[static_cast<std::size_t>(place.part)],
                      material = material_of(scenario, point, place.part);
    on = material.empty() ? fmt::format("on {}, ", part.empty() ? "the terrain" : part)
         : part.empty()   ? fmt::format("on {}, ", material)
                          : fmt::format("on {} (part {}), ", material, part);
  } else if (place.reason == StopReason::timed_out) {
    on = scenario.rock_contacts ? "in the air or on other rocks, " : "in the air, ";
  } else {
    on = "at ";
  }
  on += range_text("x", place.low.x(), place.high.x());
  if (scenario.dimension == 3) on += ", " + range_text("y", place.low.y(), place.high.y());
  return on;
}

std::string censored_answer(const Plan& plan, const Results& results) {
  std::vector<std::vector<CensoredPlace>> places;
  for (const PointResult& point : results.points) places.push_back(point.censored);
  const std::vector<CensoredPlace> all = joined(places);
  const std::string share =
      share_over(plan, results, [](const PointResult& point) { return point.groups.front().censored_share; });
  if (all.empty())
    return results.points.size() > 1 ? " No rock is censored."
                                     : fmt::format(" Censored: {} of the rocks.", share);
  constexpr std::size_t most_named = 3;
  std::vector<std::string> where;
  std::uint64_t elsewhere = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i < most_named)
      where.push_back(why_and_where(plan.points.front(), results.points.front(), all[i]));
    else
      elsewhere += all[i].rocks;
  }
  if (elsewhere > 0) where.push_back(fmt::format("{} elsewhere", elsewhere));
  return fmt::format(" {} of the rocks are censored: {}. Their distances are lower bounds.", share,
                     fmt::join(where, "; "));
}

std::string trees_answer(const Plan& plan, const Results& results) {
  if (!results.points.front().trees) return "";
  const auto of = [&](Share TreeSummary::*share) {
    return share_over(plan, results, [&](const PointResult& point) {
      return point.trees ? (*point.trees).*share : Share();
    });
  };
  return fmt::format("Trees stop {} of the {}; {} hit at least one. ", of(&TreeSummary::stopped_share),
                     plan.points.front().bodies.empty() ? "rocks" : "bodies", of(&TreeSummary::hit_share));
}

std::string barriers_answer(const Plan& plan, const Results& results) {
  const Scenario& scenario = plan.points.front();
  const std::size_t count = scenario.barriers.size();
  constexpr std::size_t most_named = 4;  // for more a table says more than a sentence
  if (count == 0) return "";
  std::string text;
  const auto caught = [](const PointResult& point) { return point.crossings.front().caught; };
  if (count > most_named)
    text = fmt::format("The {} barriers catch {} of the {}. ", count, share_over(plan, results, caught),
                       scenario.bodies.empty() ? "rocks" : "bodies");
  else
    for (std::size_t b = 0; b < count; ++b)
      text += scenario.bodies.empty() ? of_rocks(scenario.barriers[b].name, plan, results, b)
                                      : of_bodies(scenario.barriers[b].name,
                                                  results.points.front().crossings.front().barriers.at(b));
  const bool any = std::any_of(results.points.begin(), results.points.end(),
                               [&](const PointResult& point) { return caught(point).value > 0; });
  if (scenario.bodies.empty() && any) text += "Distances hold only while the barriers stand. ";
  return text;
}

std::string gates_answer(const Plan& plan, const Results& results) {
  const Scenario& scenario = plan.points.front();
  constexpr std::size_t most_named = 4;
  if (scenario.gates.size() > most_named || !scenario.bodies.empty()) return "";
  std::string text;
  for (std::size_t g = 0; g < scenario.gates.size(); ++g) {
    std::vector<std::size_t> groups = named_groups(
        plan, results, [g](const CrossingSummary& crossings) { return crossings.gates.at(g).passed > 0; });
    if (groups.empty()) groups = {0};  // of no group a rock passes
    for (const std::size_t group : groups) {
      const auto passed = [g](const CrossingSummary& crossings) { return crossings.gates.at(g).shares; };
      text += fmt::format("Gate {}{}: in {} of the trials at least one rock passes. ", scenario.gates[g].name,
                          group_suffix(results, group), per_trial_over_points(plan, results, group, passed));
    }
  }
  return text;
}

}  // namespace flyrock
