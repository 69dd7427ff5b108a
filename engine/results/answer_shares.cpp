#include "results/answer_shares.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace flyrock {

std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

namespace {

std::string interval_text(const Interval& interval) {
  if (interval.lower == 0)
    return fmt::format("{} interval up to {}", percent(stated_confidence), percent(interval.upper));
  return fmt::format("{} interval {:.3g} to {}", percent(stated_confidence), 100 * interval.lower,
                     percent(interval.upper));
}

/// For one point, the share with its interval. In a sweep, the least to the greatest share without an
/// interval, because each point has its own.
std::string over_points(std::vector<Share> shares) {
  if (shares.size() == 1) return display(shares.front());
  std::erase_if(shares, [](const Share& share) { return std::isnan(share.value); });
  if (shares.empty()) return "-";
  const auto less = [](const Share& a, const Share& b) { return a.value < b.value; };
  const auto [low, high] = std::minmax_element(shares.begin(), shares.end(), less);
  if (low->value == high->value) return percent(low->value);
  return fmt::format("{:.3g} to {}", 100 * low->value, percent(high->value));
}

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

/// "75 % (95 % interval 68.4 to 80.8 %)", "<= 75 % (...)".
std::string display(const Complement& share) {
  return fmt::format("{}{} ({})", share.is_upper_bound ? "<= " : "", percent(share.value),
                     interval_text(share.interval));
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

std::string of_rocks(const std::string& name, const Results& results, std::size_t b) {
  const auto at = [b](const PointResult& point) { return point.crossings.front().barriers.at(b); };
  const auto of = [&](BarrierShare what) {
    std::vector<Share> shares;
    for (const PointResult& point : results.points) shares.push_back(at(point).share(what).of_all);
    return over_points(std::move(shares));
  };
  const auto is_reached = [&](const PointResult& point) {
    return at(point).count(BarrierShare::reached) > 0;
  };
  if (std::none_of(results.points.begin(), results.points.end(), is_reached))
    return fmt::format("Barrier {}: {} of the rocks reach it. ", name, of(BarrierShare::reached));
  const std::string others =
      results.points.size() == 1
          ? fmt::format(
                ", and {} do not reach it",
                display(complement_of(at(results.points.front()).share(BarrierShare::reached).of_all)))
          : fmt::format("; {} reach it", of(BarrierShare::reached));
  return fmt::format("Barrier {} catches {} of the rocks; {} go over the top, {} go through it{}. ", name,
                     of(BarrierShare::caught), of(BarrierShare::over_top), of(BarrierShare::over_energy),
                     others);
}

}  // namespace

std::string display(const Share& share) {
  if (std::isnan(share.value)) return "-";
  return fmt::format("{}{} ({})", share.censored ? ">= " : "", percent(share.value),
                     interval_text(share.interval));
}

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
    on = "in the air, ";
  } else {
    on = "at ";
  }
  on += range_text("x", place.low.x(), place.high.x());
  if (scenario.dimension == 3) on += ", " + range_text("y", place.low.y(), place.high.y());
  return on;
}

std::string censored_answer(const Plan& plan, const Results& results) {
  std::vector<Share> shares;
  std::vector<std::vector<CensoredPlace>> places;
  for (const PointResult& point : results.points) {
    const GroupSummary& all = point.groups.front();
    shares.push_back(all.censored_share);
    places.push_back(point.censored);
  }
  const std::vector<CensoredPlace> all = joined(places);
  if (all.empty())
    return shares.size() > 1
               ? " No rock is censored."
               : fmt::format(" No rock is censored ({}).", interval_text(shares.front().interval));
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
  const std::string share = shares.size() > 1 ? over_points(shares) : percent(shares.front().value);
  const std::string interval =
      shares.size() > 1 ? "" : fmt::format(" ({})", interval_text(shares.front().interval));
  return fmt::format(" {} of the rocks are censored{}: {}. Their distances are lower bounds.", share,
                     interval, fmt::join(where, "; "));
}

std::string trees_answer(const Plan& plan, const Results& results) {
  std::vector<Share> hit, stopped;
  for (const PointResult& point : results.points) {
    if (!point.trees) continue;
    hit.push_back(point.trees->hit_share);
    stopped.push_back(point.trees->stopped_share);
  }
  if (hit.empty()) return "";
  return fmt::format("Trees stop {} of the {}; {} hit at least one. ", over_points(stopped),
                     plan.points.front().bodies.empty() ? "rocks" : "bodies", over_points(hit));
}

std::string barriers_answer(const Plan& plan, const Results& results) {
  const Scenario& scenario = plan.points.front();
  const std::size_t count = scenario.barriers.size();
  constexpr std::size_t most_named = 4;  // for more a table says more than a sentence
  if (count == 0) return "";
  std::string text;
  std::vector<Share> caught;
  for (const PointResult& point : results.points) {
    caught.push_back(point.crossings.front().caught);
  }
  if (count > most_named)
    text = fmt::format("The {} barriers catch {} of the {}. ", count, over_points(caught),
                       scenario.bodies.empty() ? "rocks" : "bodies");
  else
    for (std::size_t b = 0; b < count; ++b)
      text += scenario.bodies.empty()
                  ? of_rocks(scenario.barriers[b].name, results, b)
                  : of_bodies(scenario.barriers[b].name, results.points.front().barriers.at(b));
  const auto any = [](const Share& share) { return share.value > 0; };
  if (scenario.bodies.empty() && std::any_of(caught.begin(), caught.end(), any))
    text += "Distances hold only while the barriers stand. ";
  return text;
}

}  // namespace flyrock
