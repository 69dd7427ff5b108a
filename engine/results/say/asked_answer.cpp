#include "results/say/asked_answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/bearing.h"
#include "results/say/answer.h"
#include "results/say/wording.h"
#include "scenario/plan.h"

namespace flyrock {

namespace {

/// Who goes farther than a clearance: "rocks of face go", "blasts (with 3 rocks a blast) throw a rock of
/// face".
std::string who_goes(const Scenario& scenario, const ClearancePlan& asked, const ClearanceSummary& found) {
  const std::string of =
      asked.group < 0 ? "" : " of " + scenario.rocks.at(static_cast<std::size_t>(asked.group)).name;
  if (!asked.per_blast)
    return fmt::format("rocks{} {}", of, scenario.method == Method::ballistic ? "first land" : "go");
  const double rocks = found.rocks_per_blast();
  return fmt::format("blasts (with {:.4g} rock{} a blast) throw a rock{}{}", rocks, rocks == 1 ? "" : "s", of,
                     scenario.method == Method::ballistic ? " that first lands" : "");
}

/// "Area of people: with 95 % confidence at most 2 % of new rocks stop outside; it reaches "
std::string area_of(const ClearancePlan& asked) {
  return fmt::format("Area of {}: with {} confidence at most {} of new {} outside; it reaches ", asked.name,
                     percent(stated_confidence), percent(asked.probability),
                     asked.per_blast ? "blasts throw a rock" : "rocks stop");
}

std::string from_of(const ClearancePlan& asked) {
  return asked.about ? "the given point" : "the hull of the release places";
}

/// "Clearance road: at most 0.1 % of the rocks go farther than 320 m (95 % interval 301 to 345 m) (mu 0.2) to
/// ... With the factor 1.5 that is 480 m (mu 0.2) to ..." With sectors, the greatest distance of the area.
std::string clearance_over_points(const Plan& plan, const Results& results, std::size_t c) {
  const ClearancePlan& asked = plan.points.front().clearances[c];
  const auto at = [&](std::size_t p) -> const ClearanceSummary& {
    return results.points[p].clearances.at(c);
  };
  const auto distance_text = [&](std::size_t p) {
    if (asked.sectors > 0) return display(at(p).distance, "m");
    return with_interval(at(p).distance, at(p).interval, asked.confidence);
  };
  const auto value_at = [&](std::size_t p) { return at(p).distance.value; };
  const std::string distance = over_points(plan, results, value_at, distance_text);
  std::string text = asked.sectors > 0 ? area_of(asked) + distance + " from " + from_of(asked)
                                       : fmt::format("Clearance {}: at most {} of the {} farther than {}",
                                                     asked.name, percent(asked.probability),
                                                     who_goes(plan.points.front(), asked, at(0)), distance);
  text += '.';
  if (asked.factor)
    text += fmt::format(" With the factor {} that is {}.", three_digits(*asked.factor),
                        over_points(plan, results, value_at, [&](std::size_t p) {
                          return display({at(p).with_factor, at(p).distance.censored}, "m");
                        }));
  return text;
}

/// " Least area of road: 3.1 ha in 2 parts; with 95 % confidence at most 2 % of new rocks stop outside. A
/// circle about the release places takes 24.3 ha (278 m)."
std::string least_area_answer(const Plan& plan, const Results& results, std::size_t c) {
  const ClearancePlan& asked = plan.points.front().clearances[c];
  if (!asked.least_area) return {};
  const auto at = [&](std::size_t p) -> const LeastArea& {
    return results.points[p].clearances.at(c).least_area;
  };
  const bool one = results.points.size() == 1;
  const char* of = asked.per_blast ? "blasts" : "rocks";
  if (one && !at(0).beyond)
    return fmt::format(
        " Least area of {}: there is none, {} {} that are independent are too few in half of the trials.",
        asked.name, three_digits(at(0).effective), of);
  const auto hectares = [](double value) { return three_digits(value) + " ha"; };
  std::string text = fmt::format(
      " Least area of {}: {}", asked.name,
      over_points(
          plan, results, [&](std::size_t p) { return at(p).hectares; },
          [&](std::size_t p) { return (at(p).censored > 0 ? ">= " : "") + hectares(at(p).hectares); }));
  if (one && at(0).polygons.size() > 1) text += fmt::format(" in {} parts", at(0).polygons.size());
  text += fmt::format("; with {} confidence at most {} of new {} outside.", percent(stated_confidence),
                      percent(asked.probability), asked.per_blast ? "blasts throw a rock" : "rocks stop");
  if (one && !std::isnan(at(0).circle_hectares))
    text += fmt::format(" A circle about the release places takes {} ({} m).",
                        hectares(at(0).circle_hectares), three_digits(at(0).circle_distance));
  return text;
}

/// " Beside it: the customary distance is 300 m; 1.5 times the farthest known throw is 270 m."
std::string beside_clearance(const ClearancePlan& asked) {
  if (!asked.customary && !asked.known_throw) return {};
  std::string text = " Beside it:";
  if (asked.customary)
    text += fmt::format(" the legal or customary distance is {} m", three_digits(*asked.customary));
  if (asked.customary && asked.known_throw) text += ";";
  if (asked.known_throw)
    text += fmt::format(" {} times the farthest known throw is {} m", three_digits(beyond_known_throw),
                        three_digits(beyond_known_throw * *asked.known_throw));
  return text + '.';
}

/// "0.012 % (one blast in 8,300; 95 % interval 0.009 to 0.016 %)". Of one that no rock came near, the bound.
std::string hit_text(const ExposureSummary& found, std::uint64_t trials) {
  const BlastBounds& hit = found.per_blast;
  if (!(hit.upper > 0))
    return fmt::format("below {} (no rock of {} blasts landed within {} m; 95 % bound)",
                       percent(hit.interval.upper), trials, three_digits(found.radius));
  const std::string interval = fmt::format("95 % interval {} to {} %", three_digits(100 * hit.interval.lower),
                                           three_digits(100 * hit.interval.upper));
  if (!hit.tells())
    return fmt::format("between {} and {} ({}; {})", three_digits(100 * hit.lower), percent(hit.upper),
                       interval, telling_text(hit));
  return fmt::format("{} (one blast in {}; {})", percent(hit.upper), three_digits(1 / hit.upper), interval);
}

/// "Exposure house: a blast hits it with the probability 0.012 % (...), in a year of 50 blasts and occupied
/// 100 % of the time with 0.6 %." Of traffic a vehicle, and how often a rock lands on the road.
std::string exposure_over_points(const Plan& plan, const Results& results, std::size_t e) {
  const ExposurePlan& asked = plan.points.front().exposures[e];
  const bool traffic = asked.has_traffic();
  const auto at = [&](std::size_t p) -> const ExposureSummary& { return results.points[p].exposures.at(e); };
  const auto over = [&](auto value_at, auto text_at) {
    return over_points(plan, results, value_at, text_at);
  };
  std::string text = fmt::format(
      "Exposure {}: a blast hits {} with the probability {}", asked.name, traffic ? "a vehicle" : "it",
      over([&](std::size_t p) { return at(p).per_blast.upper; },
           [&](std::size_t p) { return hit_text(at(p), results.points[p].trials); }));
  if (asked.blasts_per_year != 1 || (asked.occupied != 1 && !traffic))
    text += fmt::format(", in a year of {} blast{}{} with {}", three_digits(asked.blasts_per_year),
                        asked.blasts_per_year == 1 ? "" : "s",
                        traffic ? "" : fmt::format(" and occupied {} of the time", percent(asked.occupied)),
                        over([&](std::size_t p) { return at(p).per_year; },
                             [&](std::size_t p) {
                               const bool none = !(at(p).per_blast.upper > 0);
                               return (none ? "below " : "") +
                                      percent(none ? at(p).per_year_interval.upper : at(p).per_year);
                             }));
  if (traffic)
    text += fmt::format("; a rock lands on the road with {}",
                        over([&](std::size_t p) { return at(p).road_hit; },
                             [&](std::size_t p) { return percent(at(p).road_hit); }));
  return text + '.';
}

/// "The area of people reaches farthest at bearing 45 deg, north-east, from the hull of the release places."
std::string area_direction(const Plan& plan, const ClearancePlan& asked, const ClearanceSummary& found) {
  if (asked.sectors == 0 || !found.area.farthest()) return {};
  return fmt::format(" The area of {} reaches farthest at {}, from {}.", asked.name,
                     bearing_text(found.area.farthest()->azimuth, plan.points.front().terrain.north),
                     from_of(asked));
}

/// " A blast has 3600 rocks." The farthest rock of few is nearer than the farthest of many.
std::string rocks_of_blasts(const Plan& plan, const Results& results) {
  const std::vector<ClearancePlan>& asked = plan.points.front().clearances;
  std::vector<std::string> told;
  std::string text;
  for (std::size_t c = 0; c < asked.size(); ++c) {
    const ClearanceSummary& found = results.points.front().clearances.at(c);
    if (!asked[c].per_blast || found.count == 0) continue;
    const double rocks = found.rocks_per_blast();
    std::string sentence = fmt::format(
        " A blast has {:.4g} rock{}{}.", rocks, rocks == 1 ? "" : "s",
        asked[c].group < 0
            ? ""
            : " of " + plan.points.front().rocks.at(static_cast<std::size_t>(asked[c].group)).name);
    if (found.is_upper_bound(asked[c]))
      sentence +=
          fmt::format(" The distance of {} is an upper bound, because a rock stands for {} real ones.",
                      asked[c].name, three_digits(found.weight));
    if (std::find(told.begin(), told.end(), sentence) != told.end()) continue;
    text += sentence;
    told.push_back(std::move(sentence));
  }
  return text;
}

}  // namespace

std::string asked_over_points(const Plan& plan, const Results& results) {
  const Scenario& scenario = plan.points.front();
  std::string text;
  for (std::size_t c = 0; c < scenario.clearances.size(); ++c)
    text += clearance_over_points(plan, results, c) + least_area_answer(plan, results, c) +
            beside_clearance(scenario.clearances[c]) + ' ';
  for (std::size_t e = 0; e < scenario.exposures.size(); ++e)
    text += exposure_over_points(plan, results, e) + ' ';
  return text;
}

std::string beside_questions(const Plan& plan, const Results& results) {
  const Scenario& scenario = plan.points.front();
  const PointResult& point = results.points.front();
  std::string text;
  for (std::size_t c = 0; c < scenario.clearances.size(); ++c) {
    const ClearancePlan& asked = scenario.clearances[c];
    text += area_direction(plan, asked, point.clearances.at(c)) + least_area_answer(plan, results, c);
    if (asked.known_throw)
      text += fmt::format(" {} times the farthest known throw is {} m.", three_digits(beyond_known_throw),
                          three_digits(beyond_known_throw * *asked.known_throw));
  }
  text += rocks_of_blasts(plan, results);
  for (std::size_t e = 0; e < scenario.exposures.size(); ++e)
    if (scenario.exposures[e].has_traffic())
      text += fmt::format(" A rock lands on {} in {} of the blasts.", scenario.exposures[e].name,
                          percent(point.exposures.at(e).road_hit));
  return text.empty() ? text : text.substr(1) + ' ';
}

}  // namespace flyrock
