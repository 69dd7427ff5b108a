#include "results/compare/barrier_choice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "results/measured/lost.h"
#include "results/say/farthest_group.h"
#include "results/say/wording.h"
#include "scenario/plan.h"

namespace flyrock {

namespace {

/// "height" of "barriers.0.height"
std::string_view last_step(std::string_view path) { return path.substr(path.find_last_of('.') + 1); }

bool is_strength(const SweepAxis& axis, std::size_t barrier) {
  return !axis.is_choice() && axis.path.starts_with(fmt::format("barriers.{}.", barrier)) &&
         (last_step(axis.path) == "height" || last_step(axis.path) == "capacity");
}

std::vector<std::size_t> axes_where(const Plan& plan, std::size_t barrier, bool strength) {
  std::vector<std::size_t> axes;
  for (std::size_t a = 0; a < plan.axes.size(); ++a)
    if (is_strength(plan.axes[a], barrier) == strength) axes.push_back(a);
  return axes;
}

const Share& past_at(const BarrierSummary& barrier, HeldSense sense) {
  const Shares& past = barrier.share(BarrierShare::past);
  if (sense == HeldSense::per_trial) return past.per_trial;
  return sense == HeldSense::of_arriving ? past.of_arriving : past.of_all;
}

bool holds(const PointResult& point, const BarrierChoice& choice) {
  const Interval& past =
      past_at(point.crossings.at(choice.group).barriers.at(choice.barrier), choice.sense).interval;
  return is_tried(point, choice.barrier, choice.group) && past.upper <= 1 - choice.held;
}

/// "x 11 m": the values of the axes of a place.
std::string where_text(const Plan& plan, const std::vector<std::size_t>& axes, std::size_t point) {
  std::vector<std::string> values;
  for (const std::size_t a : axes)
    values.push_back(
        fmt::format("{} {}", last_step(plan.axes[a].path), value_text(plan.axes[a], plan.at[point][a])));
  return fmt::format("{}", fmt::join(values, ", "));
}

/// "2 m high with 50 kJ", or what is swept of it.
std::string size_text(const Plan& plan, const std::vector<std::size_t>& strengths, std::size_t point) {
  std::string height, capacity;
  for (const std::size_t a : strengths) {
    const std::string value = value_text(plan.axes[a], plan.at[point][a]);
    if (last_step(plan.axes[a].path) == "height")
      height = value + " high";
    else
      capacity = value;
  }
  return height + (height.empty() || capacity.empty() ? "" : " with ") + capacity;
}

/// Whether the barrier of point p has less height or capacity than that of q, and no more of the other.
bool is_smaller(const Plan& plan, const std::vector<std::size_t>& strengths, std::size_t p, std::size_t q) {
  bool less = false;
  for (const std::size_t a : strengths) {
    if (plan.at[p][a] > plan.at[q][a]) return false;
    less |= plan.at[p][a] < plan.at[q][a];
  }
  return less;
}

/// The points at each place, in their order.
std::vector<std::vector<std::size_t>> points_by_place(const Plan& plan,
                                                      const std::vector<std::size_t>& axes) {
  std::vector<std::vector<std::size_t>> places;
  std::map<std::vector<double>, std::size_t> known;
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    std::vector<double> at;
    for (const std::size_t a : axes) at.push_back(plan.at[p][a]);
    const auto [found, is_new] = known.try_emplace(at, places.size());
    if (is_new) places.emplace_back();
    places[found->second].push_back(p);
  }
  return places;
}

std::string place_text(const Plan& plan, const std::vector<PointResult>& points, const BarrierChoice& choice,
                       const std::vector<std::size_t>& place, const std::vector<std::size_t>& smallest) {
  const std::string where = where_text(plan, axes_where(plan, choice.barrier, false), place.front());
  const auto tried = [&](std::size_t p) { return is_tried(points[p], choice.barrier, choice.group); };
  std::vector<std::string> names;
  for (const std::size_t p : smallest)
    names.push_back(size_text(plan, axes_where(plan, choice.barrier, true), p));
  const std::string what = !names.empty() ? fmt::format("{}", fmt::join(names, ", or "))
                           : std::any_of(place.begin(), place.end(), tried) ? "none of the sweep"
                                                                            : "too few rocks arrive to tell";
  return where.empty() ? what : where + ": " + what;
}

}  // namespace

bool is_tried(const PointResult& point, std::size_t barrier, std::size_t group) {
  const Shares& reached = point.crossings.at(group).barriers.at(barrier).share(BarrierShare::reached);
  return reached.blast.lower * static_cast<double>(point.trials) > least_trials - 0.5;
}

std::vector<std::size_t> swept_barriers(const Plan& plan) {
  std::vector<std::size_t> swept;
  for (std::size_t b = 0; b < plan.points.front().barriers.size(); ++b)
    if (!axes_where(plan, b, true).empty()) swept.push_back(b);
  return swept;
}

BarrierChoice choose_barrier(const Plan& plan, const std::vector<PointResult>& points, std::size_t barrier,
                             std::size_t group, HeldSense sense, double held) {
  BarrierChoice choice{.barrier = barrier, .group = group, .sense = sense, .held = held};
  const std::vector<std::size_t> strengths = axes_where(plan, barrier, true);
  std::vector<std::string> texts;
  for (const std::vector<std::size_t>& place : points_by_place(plan, axes_where(plan, barrier, false))) {
    std::vector<std::size_t> holding, smallest;
    for (const std::size_t p : place)
      if (!has_lost(plan.points[p], points[p]) && holds(points[p], choice)) holding.push_back(p);
    for (const std::size_t p : holding)
      if (std::none_of(holding.begin(), holding.end(),
                       [&](std::size_t other) { return is_smaller(plan, strengths, other, p); }))
        smallest.push_back(p);
    texts.push_back(place_text(plan, points, choice, place, smallest));
    choice.holding.insert(choice.holding.end(), holding.begin(), holding.end());
    choice.smallest.insert(choice.smallest.end(), smallest.begin(), smallest.end());
  }
  constexpr std::size_t most_named = 10;
  const std::size_t more = texts.size() > most_named ? texts.size() - most_named : 0;
  texts.resize(texts.size() - more);
  choice.text = fmt::format("{}", fmt::join(texts, ". "));
  if (more > 0) choice.text += fmt::format(". And {} more places, in the table of the page", more);
  return choice;
}

std::vector<BarrierChoice> barrier_choices(const Plan& plan, const std::vector<PointResult>& points) {
  std::vector<BarrierChoice> choices;
  for (const std::size_t barrier : swept_barriers(plan))
    for (std::size_t group = 0; group < points.front().crossings.size(); ++group)
      for (std::size_t sense = 0; sense < held_sense_names.size(); ++sense)
        for (const double held : held_shares)
          choices.push_back(
              choose_barrier(plan, points, barrier, group, static_cast<HeldSense>(sense), held));
  return choices;
}

std::string barrier_choice_text(const Plan& plan, const Results& results) {
  const Scenario& scenario = plan.points.front();
  if (!scenario.bodies.empty()) return {};
  std::string text;
  const std::size_t group = farthest_group(results.points.front().groups);
  for (const std::size_t barrier : swept_barriers(plan)) {
    const std::string of = group == 0 ? "" : " of " + results.points.front().groups[group].name;
    text += fmt::format(
        "{}Smallest {} of the sweep that no rock{} gets past in {} of the trials, with {} confidence: {}.",
        text.empty() ? "" : " ", scenario.barriers[barrier].name, of, percent(usual_held_share),
        percent(stated_confidence),
        choose_barrier(plan, results.points, barrier, group, HeldSense::per_trial, usual_held_share).text);
  }
  return text;
}

}  // namespace flyrock
